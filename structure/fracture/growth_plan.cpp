// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/growth_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <unordered_set>

#include "common/log.hpp"
#include "structure/dynamics/in_situ.hpp"
#include "structure/fracture/failure_path.hpp"
#include "structure/fracture/hoop_direction.hpp"
#include "structure/fracture/nucleation.hpp"
#include "structure/fracture/patch_selection.hpp"
#include "structure/fracture/tip_stress.hpp"
#include "structure/joints/joining_vertices.hpp"
#include "structure/joints/network_topology.hpp"
#include "structure/mesh/segment_tree.hpp"

namespace fissura::structure {

namespace {

// In units of tip_size.
constexpr double trigger_radius = 2, trigger_width = 1;
constexpr double direction_radius = 3, direction_width = 1.5;

struct PatchAttempt {
  double radius = 0;
  CoarseElements coarse_elements = CoarseElements::refined;
};
constexpr std::array patch_attempts{
    PatchAttempt{2.2, CoarseElements::refined}, PatchAttempt{2.97, CoarseElements::refined},
    PatchAttempt{2.2, CoarseElements::left}, PatchAttempt{2.97, CoarseElements::left},
    PatchAttempt{4.0, CoarseElements::left}};
constexpr double least_altitude =
    0.4;  // about half of what the first mesh has at h, so that the stable step does not fall more

double deviation_from_chord(const std::vector<Point>& points) {
  double greatest = 0;
  for (const Point& point : points)
    greatest = std::max(greatest, distance_to_segment(point, points.front(), points.back()));
  return greatest;
}

class GrowthPlanner {
 public:
  GrowthPlanner(const StructureModel& model, const Geometry& geometry, const StructureState& state)
      : model_(model), geometry_(geometry), state_(state), controls_(model.run_case.mesh) {
    if (forms_from_failed_rock(model.run_case)) map_.emplace(model, geometry, state);
  }

  std::optional<GrowthPlan> plan(double time) {
    GrowthPlan plan;
    for (const FractureTip& tip : tips())
      if (const auto ends = next_ends(tip)) {
        const auto meeting = meet(now_, tip, ends->back(), time);
        if (!add(plan_growth_of(tip, *ends, plan), plan, arrivals_.split) || !meeting) continue;
        plan.meetings.push_back(*meeting);
        plan.meeting_patch.push_back(plan.patches.size() - 1);
      }
    if (model_.run_case.growth.nucleation)
      for (const Nucleus& nucleus : nuclei(now_, *map_))
        add(plan_nucleus(nucleus, plan), plan, arrivals_.nucleated);
    if (plan.patches.empty()) return std::nullopt;
    plan.insertion = connect(*fractures_, geometry_.network,
                             joining_vertices(*fractures_, state_.joints, geometry_.network, arrivals_),
                             model_.run_case, time);
    return plan;
  }

 private:
  [[nodiscard]] std::vector<FractureTip> tips() const {
    std::vector<FractureTip> tips = fracture_tips(geometry_.mesh);
    if (model_.run_case.growth.tip == TipRule::damage) return tips;
    for (const FractureTip& tip : natural_ends(geometry_.mesh, state_.joints)) tips.push_back(tip);
    for (const FractureTip& tip : crossing_tips(geometry_, state_.crossing_seeds)) tips.push_back(tip);
    return tips;
  }

  // Returns whether there was a patch.
  bool add(std::optional<PatchPlan> patch, GrowthPlan& plan, std::vector<VertexIndex>& split) {
    if (!patch) return false;
    Mesh& fractures = planned_fractures();
    fractures.vertices.insert(fractures.vertices.end(), patch->new_vertices.begin(),
                              patch->new_vertices.end());
    for (const FractureEdge& edge : patch->new_edges) add_edge(fractures, edge);
    fractures.lines.resize(geometry_.mesh.lines.size());
    fractures.lines.insert(fractures.lines.end(), plan.new_lines.begin(), plan.new_lines.end());
    for (const VertexIndex vertex : patch->split)
      if (!geometry_.network.contains(vertex)) split.push_back(vertex);
    plan.patches.push_back(std::move(*patch));
    return true;
  }

  // The fractures as they will be, without the units to come.
  Mesh& planned_fractures() {
    if (!fractures_) {
      fractures_.emplace();
      fractures_->lines = geometry_.mesh.lines;
      fractures_->vertices = geometry_.mesh.vertices;
      fractures_->edges = geometry_.mesh.edges;
      fractures_->units = geometry_.mesh.units;
    }
    return *fractures_;
  }

  [[nodiscard]] InPlane<double> average(const FractureTip& tip, double radius, double width,
                                        HalfDisc::Weighting weighting) const {
    const double h = controls_.tip_size;
    return average_stress(geometry_.mesh, geometry_.node_elements, geometry_.body, model_.moduli,
                          state_.body.displacement,
                          {tip.position, tip.node, tip.direction, radius * h, width * h, weighting});
  }

  [[nodiscard]] bool fails(const FractureTip& tip, double greatest_stress) const {
    const Rock& rock = model_.run_case.rock;
    const double strength = tip_strength(rock.tensile_strength, rock.fracture_energy,
                                         rock.plane_strain_modulus(), controls_.tip_size);
    const double pressure = std::max(adjacent_pressure(geometry_.mesh, state_.joints, tip),
                                     in_situ_state(model_.run_case, tip.position).pore_pressure);
    return greatest_stress + pressure >= model_.run_case.growth.trigger * strength;
  }

  // Direction in which the rock ahead of a tip fails; nothing if it does not.
  [[nodiscard]] std::optional<std::array<double, 2>> failing_direction(const FractureTip& tip) const {
    if (tip.kind == FractureTip::Kind::natural_end) {
      const Kink kink = greatest_hoop_kink(geometry_.mesh, geometry_.node_elements, geometry_.body,
                                           model_.moduli, state_.body.displacement,
                                           {tip.position, tip.node, tip.direction, controls_.tip_size});
      if (!fails(tip, kink.stress)) return std::nullopt;
      return kink.direction;
    }
    if (!fails(tip, principal(average(tip, trigger_radius, trigger_width, HalfDisc::Weighting::near)).major))
      return std::nullopt;
    return growth_direction(average(tip, direction_radius, direction_width, HalfDisc::Weighting::ahead),
                            tip.direction, model_.run_case.growth.turn_limit);
  }

  [[nodiscard]] std::optional<std::vector<SegmentEnd>> next_ends(const FractureTip& tip) const {
    const Growth& growth = model_.run_case.growth;
    if (growth.tip == TipRule::damage) return failure_path(now_, *map_, tip);
    const auto direction = failing_direction(tip);
    if (!direction) return std::nullopt;
    const double h = controls_.tip_size;
    const NextSegment segment =
        next_segment(geometry_.mesh, model_.run_case.domain, tip, *direction, growth.segment_length * h, h);
    if (!segment.end) return std::nullopt;
    return std::vector{*segment.end};
  }

  std::optional<PatchPlan> plan_growth_of(const FractureTip& tip, const std::vector<SegmentEnd>& ends,
                                          GrowthPlan& plan) {
    std::vector<LineVertex> line{{tip.position, tip.vertex}};
    for (const SegmentEnd& end : ends)
      line.push_back(
          {end.position, end.kind == SegmentEnd::Kind::fracture ? std::optional(end.vertex) : std::nullopt});
    return plan_line(line, tip.node, [&] { return line_of(tip, plan); });
  }

  std::optional<PatchPlan> plan_nucleus(const Nucleus& nucleus, GrowthPlan& plan) {
    std::vector<LineVertex> line;
    for (const Point& point : nucleus.line) line.push_back({point, std::nullopt});
    return plan_line(line, nucleus.node, [&] { return new_line(plan); });
  }

  template <class LineIndex>
  std::optional<PatchPlan> plan_line(const std::vector<LineVertex>& line, NodeIndex node,
                                     const LineIndex& line_index) {
    const double h = controls_.tip_size;
    std::vector<Point> points;
    for (const LineVertex& vertex : line) points.push_back(vertex.position);
    const double bend = deviation_from_chord(points);
    for (const PatchAttempt& attempt : patch_attempts) {
      const PatchChoice choice = choose_patch(
          geometry_.mesh, geometry_.node_elements, controls_,
          {node, points.front(), points.back(), attempt.radius * h + bend}, attempt.coarse_elements);
      if (touches_taken(choice.elements)) return std::nullopt;
      const PatchOutline edge = outline(geometry_.mesh, choice.elements, fracture_nodes(geometry_.mesh));
      const auto mesh = mesh_patch(edge, points, choice.field, least_altitude * h);
      if (!mesh) continue;
      take(choice.elements);
      return plan_patch({geometry_.mesh, geometry_.node_elements, fracture_vertices(), line_index()}, line,
                        choice.elements, edge, *mesh);
    }
    log::warn(fmt::format("no good mesh for a fracture from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) m: it waits",
                          points.front()[0], points.front()[1], points.back()[0], points.back()[1]));
    return std::nullopt;
  }

  [[nodiscard]] std::size_t fracture_vertices() const {
    return fractures_ ? fractures_->vertices.size() : geometry_.mesh.vertices.size();
  }

  // Nodes of the patch and of the elements around it: an insertion gives some of those another node.
  void take(const std::vector<ElementIndex>& elements) {
    for (const ElementIndex element : elements)
      for (const NodeIndex node : geometry_.mesh.elements[element]) taken_.insert(node);
  }
  [[nodiscard]] bool touches_taken(const std::vector<ElementIndex>& elements) const {
    for (const ElementIndex element : elements)
      for (const NodeIndex node : geometry_.mesh.elements[element])
        for (const ElementIndex around : geometry_.node_elements.of(node))
          for (const NodeIndex corner : geometry_.mesh.elements[around])
            if (taken_.contains(corner)) return true;
    return false;
  }

  // What grew from a line is a line of its own: it has the strength of the rock.
  std::uint32_t line_of(const FractureTip& tip, GrowthPlan& plan) {
    const auto& lines = geometry_.mesh.lines;
    if (lines[tip.line].kind == FractureKind::intact) return tip.line;
    const std::string name = "growth of " + lines[tip.line].name;
    for (std::uint32_t k = 0; k < lines.size(); ++k)
      if (lines[k].name == name) return k;
    for (std::uint32_t k = 0; k < plan.new_lines.size(); ++k)
      if (plan.new_lines[k].name == name) return static_cast<std::uint32_t>(lines.size() + k);
    return add_line(name, plan);
  }

  std::uint32_t new_line(GrowthPlan& plan) {
    const auto& lines = geometry_.mesh.lines;
    const auto nucleated = [](const FractureLine& line) { return line.name.starts_with("nucleated "); };
    const auto count = std::count_if(lines.begin(), lines.end(), nucleated) +
                       std::count_if(plan.new_lines.begin(), plan.new_lines.end(), nucleated);
    return add_line(fmt::format("nucleated {}", count + 1), plan);
  }

  std::uint32_t add_line(const std::string& name, GrowthPlan& plan) {
    const Rock& rock = model_.run_case.rock;
    FractureLine& line = plan.new_lines.emplace_back();
    line.name = name;
    line.kind = FractureKind::intact;
    line.tensile_strength = rock.tensile_strength;
    line.fracture_energy = rock.fracture_energy;
    line.friction_coefficient = rock.friction_coefficient;
    return static_cast<std::uint32_t>(geometry_.mesh.lines.size() + plan.new_lines.size() - 1);
  }

  const StructureModel& model_;
  const Geometry& geometry_;
  const StructureState& state_;
  const MeshControls& controls_;
  RockNow now_{model_, geometry_, state_};
  std::optional<FailureMap> map_;  // where fractures form out of failed rock
  std::unordered_set<NodeIndex> taken_;
  std::optional<Mesh> fractures_;  // once a patch is planned
  Arrivals arrivals_;
};

}  // namespace

std::optional<GrowthPlan> plan_growth(const StructureModel& model, const Geometry& geometry,
                                      const StructureState& state, double time) {
  const auto start = std::chrono::steady_clock::now();
  std::optional<GrowthPlan> plan = GrowthPlanner(model, geometry, state).plan(time);
  if (plan)
    plan->wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return plan;
}

}  // namespace fissura::structure
