// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/conformance/still_rock.hpp"

#include <algorithm>
#include <cmath>

#include "coupler/conformance/flow_cases.hpp"
#include "coupler/conformance/topologies.hpp"

namespace fissura::coupler::conformance {

namespace {

/// So long that what a check pumps does not fill it.
constexpr double basin_length = 10;
/// Before the basin joins; so short that hardly anything flows.
constexpr double beginning = 1e-6;
constexpr int settling_intervals = 10;
constexpr double settling_time = 0.05;

/// The positive root of (A + c p)(1 + p / K) = m, in the form that c = 0 does not hurt.
double root(double aperture, double compliance, double content, double bulk_modulus) {
  const double quadratic = compliance / bulk_modulus, linear = compliance + aperture / bulk_modulus;
  const double missing = content - aperture;
  return 2 * missing / (linear + std::sqrt(linear * linear + 4 * quadratic * missing));
}

}  // namespace

double StillRock::aperture_at(double pressure) const {
  const double above = closed ? std::max(0.0, pressure - reference_pressure) : pressure - reference_pressure;
  return std::max(0.0, aperture + compliance * above);
}

double StillRock::content_at(double pressure, double bulk_modulus) const {
  return aperture_at(pressure) * (1 + pressure / bulk_modulus);
}

double StillRock::pressure_of(double content, double bulk_modulus) const {
  if (content <= aperture_at(0)) return 0;
  if (closed && content <= content_at(reference_pressure, bulk_modulus))
    return bulk_modulus * (content / aperture - 1);
  return root(aperture - compliance * reference_pressure, compliance, content, bulk_modulus);
}

StillScene::StillScene(const Candidate& candidate, const Case& run_case, const Insertion& first,
                       const StillRock& rock_)
    : driver(candidate, run_case, first), rock(rock_) {
  ask_all();
}

void StillScene::ask_all() {
  const std::size_t count = driver.network().nodes().size();
  asked.aperture.resize(count, rock.aperture);
  asked.aperture_rate.resize(count, 0.0);
  asked.reference_pressure.resize(count, rock.reference_pressure);
  asked.compliance.resize(count, rock.compliance);
  asked.closed.resize(count, rock.closed);
}

const FlowAnswer& StillScene::advance(double duration) {
  asked.begin = time;
  asked.end = time + duration;
  last = driver.advance(asked);
  time = asked.end;
  return last;
}

const FlowAnswer& StillScene::advance_many(int count, double duration) {
  for (int k = 0; k < count; ++k) advance(duration);
  return last;
}

const FlowAnswer& StillScene::come_to_rest(double conducting) {
  const double stored = rock.compliance + rock.aperture / water::bulk_modulus;
  const double diffusivity = std::pow(conducting, 3) / (12 * water::viscosity * stored);
  const double slowest = std::pow(length() / std::acos(-1.0), 2) / diffusivity;
  return advance_many(6, 100 * slowest);
}

void StillScene::insert(const Insertion& insertion) {
  driver.insert(insertion);
  ask_all();
}

double StillScene::length() const {
  return integral(driver.network(), std::vector<double>(driver.network().nodes().size(), 1.0));
}

Case puff(double rate, double end) {
  Case run_case = water_case(rate);
  add_stage(run_case, end, 0);
  return run_case;
}

OpenSlit::OpenSlit(const Candidate& candidate, const Case& run_case, const StillRock& rock_)
    : StillScene(candidate, run_case, straight_slit(nodes - 1, spacing, 0), rock_) {
  advance(beginning);
  insert(basin(driver.network(), nodes - 2, spacing, time));
}

const FlowAnswer& OpenSlit::settle() {
  return advance_many(settling_intervals, settling_time);
}

Insertion basin(const FractureNetwork& network, std::size_t from, double spacing, double time) {
  const NetworkNode& tip = network.nodes()[from];
  Insertion insertion;
  insertion.revision = network.revision() + 1;
  NetworkNode end = tip, inner = tip;
  end.id = tip.id + 20000;
  end.role = NodeRole::tip;
  end.saturated = false;
  end.formation_pressure = end.joint_compliance = 0;
  end.lumped_length = basin_length;
  end.exposure_time = time;
  const double distance = std::hypot(tip.x, tip.y);
  end.x += spacing * (distance > 0 ? tip.x / distance : 1);
  end.y += spacing * (distance > 0 ? tip.y / distance : 0);
  if (inner.role == NodeRole::tip) inner.role = NodeRole::interior;
  insertion.new_nodes = {end};
  insertion.updated_nodes = {inner};
  insertion.new_segments = {{.id = 70000 + end.id,
                             .node_a = tip.id,
                             .node_b = end.id,
                             .fracture = tip.fracture,
                             .kind = SegmentKind::hydraulic,
                             .length = spacing}};
  insertion.parents = {{end.id, tip.id}};
  return insertion;
}

}  // namespace fissura::coupler::conformance
