// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/seismicity/face_sources.hpp"

#include <algorithm>
#include <cmath>

#include "structure/dynamics/in_situ.hpp"
#include "structure/joints/face_pair.hpp"

namespace fissura::structure {

namespace {

using Plane = std::array<double, 2>;

constexpr double told_from = 1e-9;           // change of a jump that fails [m]
constexpr double negligible_motion = 1e-13;  // of a unit that did not fail [m]

struct Faces {
  Plane normal{};
  double area = 0;
};

Faces faces_of(const ObservedRock& rock, UnitIndex index) {
  const ContactUnit& unit = rock.mesh.units[index];
  const double length = std::hypot(unit.face[0], unit.face[1]);
  return {{unit.face[0] / length, unit.face[1] / length}, rock.thickness() * length};
}

Plane jump_of(const ObservedRock& rock, UnitIndex index) {
  const ContactUnit& unit = rock.mesh.units[index];
  const double *plus = &rock.displacement[2 * std::size_t{unit.plus}],
               *minus = &rock.displacement[2 * std::size_t{unit.minus}];
  return {plus[0] - minus[0], plus[1] - minus[1]};
}

PlaneTensor moment(const ObservedRock& rock, UnitIndex unit, const Plane& jump) {
  const Faces faces = faces_of(rock, unit);
  return moment_of_jump(rock.moduli, faces.normal, jump, faces.area);
}

double edge_length(const Mesh& mesh, const ContactUnit& unit) {
  double longest = 0;
  for (const EdgeIndex edge : mesh.vertices[unit.vertex].edges)
    longest = std::max(longest, mesh.edges[edge].length);
  return longest > 0 ? longest : unit.length;
}

SourceFracture fracture_of(FractureKind kind) {
  switch (kind) {
    case FractureKind::open:
      return SourceFracture::open;
    case FractureKind::natural:
      return SourceFracture::natural;
    default:
      return SourceFracture::grown;
  }
}

// What the faces transmit to each other: contact where they touch, cohesion where they are apart.
PlaneTraction transmitted(const Joints& joints, UnitIndex unit) {
  const JointProperties& properties = joints.properties[unit];
  const JointState& state = joints.state[unit];
  if (state.closed) {
    const ContactTraction contact = contact_traction(properties, state, joints.released[unit] != 0);
    return {contact.normal, contact.shear};
  }
  const CohesiveTraction pull =
      cohesion(properties.cohesive, std::max(state.opening, 0.0), state.sliding, state.greatest_separation);
  return {pull.normal, pull.tangential};
}

// Of faces that no step has seen yet.
PlaneTraction in_situ_traction(const ObservedRock& rock, UnitIndex unit) {
  const InSituState state =
      in_situ_state(rock.run_case, rock.mesh.vertices[rock.mesh.units[unit].vertex].position);
  return traction_on({state.stress, state.out_of_plane}, faces_of(rock, unit).normal);
}

bool unseen(const JointState& state) {
  return state.closed && state.held_normal == 0 && state.held_tangential == 0;
}

SourceRecord record_of(const ObservedRock& rock, const ObservedInterval& interval, const Joints& joints,
                       UnitIndex index, const Plane& jump, const PlaneTraction& before,
                       const PlaneTraction& after) {
  const ContactUnit& unit = rock.mesh.units[index];
  const Faces faces = faces_of(rock, index);
  SourceRecord record;
  record.fracture = fracture_of(joints.properties[index].kind);
  record.line = unit.line;
  record.entity = index;
  record.geometry = rock.geometry;
  record.end = interval.end;
  record.position = rock.mesh.vertices[unit.vertex].position;
  record.extent = faces.area;
  record.element_size = edge_length(rock.mesh, unit);
  record.normal = faces.normal;
  record.jump = jump;
  record.moment = moment_of_jump(rock.moduli, faces.normal, jump, faces.area);
  const PlaneTraction gain{after.normal - before.normal, after.shear - before.shear};
  record.pseudo_moment = -faces.area * record.element_size * stress_of(gain, faces.normal);
  record.normal_before = before.normal;
  record.normal_after = after.normal;
  record.shear_before = before.shear;
  record.shear_after = after.shear;
  record.fluid_pressure = joints.state[index].pressure;
  record.mass_scale = interval.mass_scale;
  return record;
}

}  // namespace

PlaneTensor FaceSources::begin_interval(const ObservedRock& rock, double time, Joints& joints) {
  const auto units = static_cast<UnitIndex>(rock.mesh.units.size());
  joints.movement.resize(units);
  known_.resize(units);
  PlaneTensor came{};
  for (UnitIndex unit = 0; unit < units; ++unit) {
    Known& known = known_[unit];
    const Plane jump = jump_of(rock, unit);
    if (known.known && jump == known.jump) continue;
    if (known.known) {
      came = came + moment(rock, unit, {jump[0] - known.jump[0], jump[1] - known.jump[1]});
    } else {
      came = came + moment(rock, unit, jump);
      const PlaneTraction traction =
          unseen(joints.state[unit]) ? in_situ_traction(rock, unit) : transmitted(joints, unit);
      known = {{}, {}, {}, time, traction, traction, true};
    }
    known.jump = jump;
  }
  return came;
}

void FaceSources::add(const FaceMovement& movement, const ObservedInterval& interval, const Plane& normal,
                      const PlaneTraction& before, Failed& failed) {
  if (failed.path == 0) {
    failed.begin = interval.begin_of_step(movement.first);
    failed.before = before;
  }
  const auto [nx, ny] = normal;
  failed.end = interval.time(movement.last);
  failed.path_time +=
      movement.path_time * (interval.end - interval.begin) + movement.path * (interval.begin - failed.begin);
  failed.path += movement.path;
  failed.jump[0] += movement.opening * nx + movement.sliding * ny;
  failed.jump[1] += movement.opening * ny - movement.sliding * nx;
  failed.growth += movement.growth;
  failed.peak_rate = std::max(failed.peak_rate, movement.peak_rate);
  failed.cracked = failed.cracked || movement.cracked;
}

void FaceSources::end_interval(const ObservedRock& rock, const ObservedInterval& interval, Joints& joints,
                               std::vector<SourceRecord>& records) {
  for (UnitIndex unit = 0; unit < known_.size(); ++unit) {
    Known& known = known_[unit];
    const Plane jump = jump_of(rock, unit);
    const PlaneTraction before = known.last;
    known.last = transmitted(joints, unit);
    for (std::size_t axis = 0; axis < 2; ++axis) known.untold[axis] += jump[axis] - known.jump[axis];
    known.jump = jump;
    FaceMovement& movement = joints.movement[unit];
    if (movement.path == 0) continue;
    Failed& failed = known.failed;
    add(movement, interval, faces_of(rock, unit).normal, before, failed);
    movement = {};
    if (std::hypot(failed.jump[0], failed.jump[1]) <= told_from) continue;
    for (std::size_t axis = 0; axis < 2; ++axis) known.untold[axis] -= failed.jump[axis];
    SourceRecord& record =
        records.emplace_back(record_of(rock, interval, joints, unit, failed.jump, failed.before, known.last));
    record.kind = failed.cracked ? SourceKind::new_crack : SourceKind::contact_slip;
    record.failing = true;
    record.begin = failed.begin;
    record.end = failed.end;
    record.centroid_time =
        std::clamp(failed.begin + failed.path_time / failed.path, failed.begin, failed.end);
    record.measure = failed.growth;
    record.peak_rate = failed.peak_rate;
    failed = {};
  }
}

void FaceSources::tell(const ObservedRock& rock, const ObservedInterval& interval, const Joints& joints,
                       UnitIndex unit, std::vector<SourceRecord>& records) {
  Known& known = known_[unit];
  if (std::hypot(known.untold[0], known.untold[1]) <= negligible_motion) return;
  SourceRecord& record =
      records.emplace_back(record_of(rock, interval, joints, unit, known.untold, known.then, known.last));
  record.kind = SourceKind::contact_opening;
  record.begin = known.since;
  record.centroid_time = (known.since + interval.end) / 2;
  known.untold = {};
  known.failed = {};
  known.since = interval.end;
  known.then = known.last;
}

void FaceSources::tell_all(const ObservedRock& rock, const ObservedInterval& interval, const Joints& joints,
                           std::vector<SourceRecord>& records) {
  for (UnitIndex unit = 0; unit < known_.size(); ++unit) tell(rock, interval, joints, unit, records);
}

PlaneTensor FaceSources::leave(const ObservedRock& rock, std::span<const UnitIndex> units) {
  PlaneTensor told{};
  for (const UnitIndex unit : units) {
    if (unit >= known_.size() || !known_[unit].known) continue;
    Known& known = known_[unit];
    told = told + moment(rock, unit, {known.jump[0] - known.untold[0], known.jump[1] - known.untold[1]});
    known = {};
  }
  return told;
}

}  // namespace fissura::structure
