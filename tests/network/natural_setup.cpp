// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/network/natural_setup.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fissura::network::test {

namespace {

constexpr double hydraulic_compliance = 1e-9, natural_compliance = 2e-10, hydraulic_opening_pressure = 8e6;

}  // namespace

NaturalSetup::NaturalSetup(Model model, const Insertion& first)
    : flow(std::move(model), first),
      opening_pressure(flow.graph.node_count(), hydraulic_opening_pressure),
      next_id_(1000),
      next_segment_(1000) {}

void NaturalSetup::join(const std::vector<std::size_t>& from, std::size_t half,
                        const NaturalFracture& natural) {
  Insertion insertion;
  std::vector<NetworkNode> grown;
  for (const std::size_t start : from) {
    const double h = natural.spacing;
    const std::size_t first = insertion.new_nodes.size();
    for (std::size_t i = 0; i <= 2 * half; ++i) {
      const bool middle = i == half;
      const double share = middle ? 2.0 / 3.0 : 1;
      insertion.new_nodes.push_back({.id = next_id_++,
                                     .x = static_cast<double>(i) * h,
                                     .y = static_cast<double>(next_id_),
                                     .lumped_length = (i == 0 || i == 2 * half ? 0.5
                                                       : middle                ? 1.5
                                                                               : 1) *
                                                      h,
                                     .fracture = 2,
                                     .role = middle ? NodeRole::junction : NodeRole::interior,
                                     .exposure_time = flow.state.time,
                                     .saturated = true,
                                     .formation_pressure = natural.formation_pressure,
                                     .joint_compliance = share * natural.joint_compliance});
      if (i > 0)
        insertion.new_segments.push_back(
            {next_segment_++, next_id_ - 2, next_id_ - 1, 2, SegmentKind::natural, h});
    }
    const NodeId middle = insertion.new_nodes[first + half].id;
    const NodeId stem = flow.graph.network().nodes()[start].id;
    insertion.new_segments.push_back({next_segment_++, stem, middle, 1, SegmentKind::hydraulic, h});
    insertion.parents.push_back({middle, stem});
    auto known = std::find_if(insertion.updated_nodes.begin(), insertion.updated_nodes.end(),
                              [&](const NetworkNode& node) { return node.id == stem; });
    if (known == insertion.updated_nodes.end())
      known = insertion.updated_nodes.insert(known, flow.graph.network().nodes()[start]);
    known->lumped_length += h / 2;
    known->role = NodeRole::junction;
  }
  insert(insertion);
  for (std::size_t i = opening_pressure.size(); i < count(); ++i) {
    const bool middle = flow.graph.network().nodes()[i].role == NodeRole::junction;
    opening_pressure.push_back(natural.opening_pressure);
    flow.interval.aperture[i] = natural.residual_aperture * (middle ? 2.0 / 3.0 : 1);
    flow.interval.compliance[i] = natural_compliance;
    flow.interval.faces[i] = Faces::in_contact;
  }
  follow();
}

void NaturalSetup::grow(std::size_t from) {
  Insertion insertion;
  NetworkNode stem = flow.graph.network().nodes()[from];
  insertion.new_nodes.push_back({.id = next_id_++,
                                 .x = -1,
                                 .y = static_cast<double>(next_id_),
                                 .lumped_length = 0.25,
                                 .fracture = 3,
                                 .role = NodeRole::tip,
                                 .exposure_time = flow.state.time});
  insertion.new_segments.push_back({next_segment_++, stem.id, next_id_ - 1, 3, SegmentKind::hydraulic, 0.5});
  insertion.parents.push_back({next_id_ - 1, stem.id});
  stem.joint_compliance *= stem.lumped_length / (stem.lumped_length + 0.25);
  stem.lumped_length += 0.25;
  insertion.updated_nodes.push_back(stem);
  insert(insertion);
  opening_pressure.push_back(hydraulic_opening_pressure);
  flow.interval.compliance.back() = hydraulic_compliance;
  follow();
}

void NaturalSetup::insert(Insertion& insertion) {
  insertion.revision = flow.graph.network().revision() + 1;
  const std::vector<double> before = flow.graph.lumped_length();
  flow.insert(insertion);
  for (std::size_t i = 0; i < before.size(); ++i)
    flow.interval.aperture[i] *= before[i] / flow.graph.lumped_length()[i];
}

void NaturalSetup::follow() {
  for (std::size_t i = 0; i < count(); ++i) {
    const double pressure = flow.state.pressure[i];
    const bool open = flow.interval.faces[i] == Faces::separated && flow.interval.aperture[i] > 1e-6;
    const bool touching = !open && pressure <= opening_pressure[i];
    flow.interval.faces[i] = touching ? Faces::in_contact : Faces::separated;
    flow.interval.reference_pressure[i] = touching ? opening_pressure[i] : pressure;
  }
}

AdvanceReport NaturalSetup::advance(double duration) {
  const AdvanceReport report = flow.advance(duration);
  for (std::size_t i = 0; i < count(); ++i)
    flow.interval.aperture[i] = predicted_aperture(flow.workspace.step.storage[i], flow.state.pressure[i]);
  follow();
  return report;
}

double NaturalSetup::relative_residual() const {
  const FluidLedger ledger = ledger_report(flow.model, flow.graph, flow.state);
  const double largest = std::max(
      {std::abs(ledger.injected), ledger.in_place, ledger.found, ledger.in_fractures, ledger.leaked});
  return std::abs(ledger.residual()) / largest;
}

NaturalSetup pumped_fracture(Model model, double aperture) {
  NaturalSetup setup(std::move(model), straight_fracture(5, 0.5, {0}));
  setup.flow.set_rigid(aperture);
  setup.flow.interval.compliance.assign(5, hydraulic_compliance);
  return setup;
}

}  // namespace fissura::network::test
