// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/scheme/scheme_state.hpp"

#include <cstring>

#include "common/byte_archive.hpp"
#include "common/errors.hpp"
#include "common/fracture_network/insertion_json.hpp"

namespace fissura::coupler {

namespace {

constexpr std::uint64_t format = 1;

double edge_at_the_tips(const Case& run_case) {
  return run_case.growth.path == PathRule::free ? run_case.mesh.tip_size : run_case.mesh.fracture_size;
}

using Values = std::vector<double>;

/// The arrays of a structure's response that the next interval builds on.
struct InterfaceArray {
  const char* name;
  Values StructureResponse::*values;
};

constexpr InterfaceArray interface_arrays[] = {
    {"aperture", &StructureResponse::aperture},
    {"aperture_rate", &StructureResponse::aperture_rate},
    {"pressure_applied", &StructureResponse::pressure_applied},
    {"pressure_opening", &StructureResponse::pressure_opening},
    {"closed", &StructureResponse::closed},
    {"broken", &StructureResponse::broken},
    {"arm_aperture_a", &StructureResponse::arm_aperture_a},
    {"arm_aperture_b", &StructureResponse::arm_aperture_b},
};

bool same_bits(const Values& a, const Values& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

std::string text_of(const std::vector<Insertion>& insertions) {
  nlohmann::json list = nlohmann::json::array();
  for (const Insertion& insertion : insertions) list.push_back(insertion_to_json(insertion));
  return list.dump();
}

std::vector<Insertion> insertions_of(const std::string& text) {
  std::vector<Insertion> insertions;
  for (const nlohmann::json& entry : nlohmann::json::parse(text))
    insertions.push_back(insertion_from_json(entry));
  return insertions;
}

void require(bool condition) {
  if (!condition)
    throw Error(ExitCode::checkpoint_unusable, "the saved scheme does not fit its own fracture network");
}

void read(ByteReader& bytes, SchemeState& state) {
  std::uint64_t found_format = 0, index = 0;
  double time = 0;
  std::string insertions;
  bytes.get(found_format);
  if (found_format != format)
    throw Error(ExitCode::checkpoint_unusable, "the saved scheme has another format");
  bytes.get(index);
  bytes.get(time);
  state.interval_control.restore(bytes);
  bytes.get(insertions);
  for (const InterfaceArray& array : interface_arrays) bytes.get(state.structure.*array.values);
  bytes.get(state.structure.stable_step);
  bytes.get(state.structure.mass_scale);
  bytes.get(state.network_pressure);
  bytes.get(state.average_rate);
  bytes.get(state.strain_energy);
  bytes.get(state.reports);
  bytes.end();
  state.clock.resume(index, time);
  state.insertions = insertions_of(insertions);
  state.network = FractureNetwork();
  for (const Insertion& insertion : state.insertions) state.network.apply(insertion);
  const std::size_t nodes = state.network.nodes().size();
  require(state.structure.aperture.size() == nodes && state.network_pressure.size() == nodes &&
          state.average_rate.size() == nodes);
}

}  // namespace

SchemeState::SchemeState(const Case& run_case, double end)
    : clock(end), interval_control(run_case.coupling, edge_at_the_tips(run_case)) {}

std::vector<std::byte> save(const SchemeState& state) {
  ENSURE(!state.structure.proposal);
  ByteWriter bytes;
  bytes.put(format);
  bytes.put(state.clock.index());
  bytes.put(state.clock.time());
  state.interval_control.save(bytes);
  bytes.put(text_of(state.insertions));
  for (const InterfaceArray& array : interface_arrays) bytes.put(state.structure.*array.values);
  bytes.put(state.structure.stable_step);
  bytes.put(state.structure.mass_scale);
  bytes.put(state.network_pressure);
  bytes.put(state.average_rate);
  bytes.put(state.strain_energy);
  bytes.put(state.reports);
  return bytes.take();
}

void restore(const std::vector<std::byte>& bytes, SchemeState& state) {
  SchemeState found = state;
  try {
    ByteReader reader(bytes);
    read(reader, found);
  } catch (const nlohmann::json::exception& fault) {
    throw Error(ExitCode::checkpoint_unusable,
                std::string("the saved scheme cannot be read: ") + fault.what());
  } catch (const ProtocolError& fault) {
    throw Error(ExitCode::checkpoint_unusable,
                std::string("the saved scheme cannot be read: ") + fault.what());
  }
  state = std::move(found);
}

std::string difference(const StructureResponse& saved, const StructureResponse& restored) {
  for (const InterfaceArray& array : interface_arrays)
    if (!same_bits(saved.*array.values, restored.*array.values)) return array.name;
  return {};
}

}  // namespace fissura::coupler
