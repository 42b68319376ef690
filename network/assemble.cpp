// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/assemble.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fissura::network {

namespace {

/// A filled node without aperture stores nothing; this fraction of a film's compressibility keeps the
/// Jacobian of a sealed group of such nodes regular. It is not in the residual.
constexpr double regularisation = 1e-6;

constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();

class Assembler {
 public:
  Assembler(const Model& model, const Graph& graph, const Step& step, std::span<const double> unknown,
            Assembly& assembly)
      : model_(model),
        graph_(graph),
        step_(step),
        unknown_(unknown),
        assembly_(assembly),
        duration_(step.duration()) {
    assembly_.residual.assign(graph.pattern().size(), 0.0);
    assembly_.jacobian.assign(graph.pattern().entries(), 0.0);
    assembly_.pressure.resize(graph.node_count());
    assembly_.moved = assembly_.round_off = 0;
  }

  void add_storage(std::span<const double> content) {
    const std::vector<std::size_t>& diagonal = graph_.pattern().diagonal;
    for (std::size_t i = 0; i < graph_.node_count(); ++i) {
      const ContentLaw& law = step_.storage[i];
      const NodeContent node = fluid_content(law, unknown_[i]);
      const double length = graph_.lumped_length()[i];
      const double stored = length * (node.content + step_.demand[i] - content[i]);
      assembly_.pressure[i] = node.pressure;
      assembly_.residual[i] += stored;
      assembly_.jacobian[diagonal[i]] +=
          length * (node.content_slope + regularisation * law.film * node.pressure_slope / law.bulk_modulus);
      assembly_.moved += std::abs(stored);
      assembly_.round_off += length * (std::abs(node.content) + std::abs(content[i]) + step_.demand[i] +
                                       law.compliance * (node.pressure + std::abs(law.reference_pressure)) +
                                       law.joint.compliance * (node.pressure + law.joint.formation_pressure));
    }
  }

  void add_fluxes() {
    const JacobianPattern& pattern = graph_.pattern();
    for (std::size_t s = 0; s < graph_.segment_count(); ++s) {
      const auto [a, b] = graph_.ends()[s];
      const double conductance = duration_ * step_.transmissibility[s];
      const double moved = conductance * (assembly_.pressure[a] - assembly_.pressure[b]);
      const double slope_a = conductance * pressure_slope(a), slope_b = conductance * pressure_slope(b);
      assembly_.residual[a] += moved;
      assembly_.residual[b] -= moved;
      assembly_.jacobian[pattern.diagonal[a]] += slope_a;
      assembly_.jacobian[pattern.diagonal[b]] += slope_b;
      assembly_.jacobian[pattern.row_a_col_b[s]] -= slope_b;
      assembly_.jacobian[pattern.row_b_col_a[s]] -= slope_a;
      assembly_.round_off += conductance * (assembly_.pressure[a] + assembly_.pressure[b]);
    }
  }

  void add_well() {
    const JacobianPattern& pattern = graph_.pattern();
    const std::vector<std::size_t>& perforations = graph_.perforations();
    const std::size_t well = graph_.node_count();
    const double well_pressure = unknown_[well] * pressure_scale;
    const double conductance = duration_ * model_.well_index;
    assembly_.well_pressure = well_pressure;
    for (std::size_t k = 0; k < perforations.size(); ++k) {
      const std::size_t node = perforations[k];
      const double injected = conductance * (well_pressure - assembly_.pressure[node]);
      const double slope = conductance * pressure_slope(node);
      assembly_.residual[node] -= injected;
      assembly_.jacobian[pattern.diagonal[node]] += slope;
      assembly_.jacobian[pattern.row_node_col_well[k]] -= conductance * pressure_scale;
      assembly_.jacobian[pattern.well] += conductance * pressure_scale;
      if (step_.well.control == WellControl::rate) {
        assembly_.residual[well] += injected;
        assembly_.jacobian[pattern.row_well_col_node[k]] -= slope;
      } else {
        assembly_.residual[well] += conductance * (well_pressure - step_.well.value);
      }
      assembly_.moved += std::abs(injected);
      assembly_.round_off += conductance * (std::abs(well_pressure) + assembly_.pressure[node]);
    }
    if (perforations.empty())
      assembly_.jacobian[pattern.well] = 1;
    else if (step_.well.control == WellControl::rate)
      assembly_.residual[well] -= duration_ * step_.well.value;
  }

  void sum_imbalance() {
    double sum = 0;
    for (const double r : assembly_.residual) sum += std::abs(r);
    assembly_.imbalance = sum;
    assembly_.round_off *= rounding;
  }

 private:
  [[nodiscard]] double pressure_slope(std::size_t node) const {
    return unknown_[node] < 0 ? 0 : pressure_scale;
  }

  const Model& model_;
  const Graph& graph_;
  const Step& step_;
  std::span<const double> unknown_;
  Assembly& assembly_;
  double duration_;
};

}  // namespace

void assemble(const Model& model, const Graph& graph, const Step& step, std::span<const double> content,
              std::span<const double> unknown, Assembly& assembly) {
  Assembler assembler(model, graph, step, unknown, assembly);
  assembler.add_storage(content);
  assembler.add_fluxes();
  assembler.add_well();
  assembler.sum_imbalance();
}

}  // namespace fissura::network
