// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/recorded_scalars.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace fissura::coupler {

namespace {

using Record = IntervalRecord;

constexpr std::array columns{
    RecordedScalar{"interval", "1", "coupling index", [](const Record& r) { return double(r.interval); }},
    RecordedScalar{"revision", "1", "topology revision", [](const Record& r) { return double(r.revision); }},
    RecordedScalar{"time", "s", "end of the interval", [](const Record& r) { return r.time; }},
    RecordedScalar{"duration", "s", "of the interval", [](const Record& r) { return r.duration; }},
    RecordedScalar{"explicit_steps", "1", "of the structure in the interval",
                   [](const Record& r) { return double(r.explicit_steps); }},
    RecordedScalar{"half_length", "m",
                   "half the trace length between the middles of last opened and last fully broken node",
                   [](const Record& r) { return r.half_length; }},
    RecordedScalar{"half_length_open", "m", "half the trace length of the opened part",
                   [](const Record& r) { return r.half_length_open; }},
    RecordedScalar{"half_length_broken", "m", "half the trace length of the fully broken part",
                   [](const Record& r) { return r.half_length_broken; }},
    RecordedScalar{"inlet_aperture", "m", "mechanical opening at the first perforation",
                   [](const Record& r) { return r.inlet_aperture; }},
    RecordedScalar{"inlet_pressure", "Pa", "total, at the first perforation",
                   [](const Record& r) { return r.inlet_pressure; }},
    RecordedScalar{"inlet_net_pressure", "Pa", "inlet_pressure minus the in-situ total closure there",
                   [](const Record& r) { return r.inlet_net_pressure; }},
    RecordedScalar{"well_pressure", "Pa", "total", [](const Record& r) { return r.well_pressure; }},
    RecordedScalar{"rate", "m3/s", "injected (+) or produced (-) at the end of the interval",
                   [](const Record& r) { return r.rate; }},
    RecordedScalar{"injected", "m3", "cumulative, net of what was produced",
                   [](const Record& r) { return r.ledger.injected; }},
    RecordedScalar{"in_place", "m3", "content at the start",
                   [](const Record& r) { return r.ledger.in_place; }},
    RecordedScalar{"found", "m3", "pore fluid found in natural fractures when they joined",
                   [](const Record& r) { return r.ledger.found; }},
    RecordedScalar{"in_fractures", "m3", "content now",
                   [](const Record& r) { return r.ledger.in_fractures; }},
    RecordedScalar{"leaked", "m3", "cumulative, into the rock",
                   [](const Record& r) { return r.ledger.leaked; }},
    RecordedScalar{"reset", "m3", "cumulative, created by carrying pressure instead of content",
                   [](const Record& r) { return r.ledger.reset; }},
    RecordedScalar{"residual", "m3", "injected + in_place + found + reset - in_fractures - leaked",
                   [](const Record& r) { return r.ledger.residual; }},
    RecordedScalar{"relative_residual", "1",
                   "|residual| over the largest volume that went through the ledger",
                   [](const Record& r) { return r.ledger.relative_residual; }},
    RecordedScalar{"efficiency", "1", "in_fractures / (injected + in_place + found)",
                   [](const Record& r) { return r.efficiency; }},
    RecordedScalar{"mismatch", "1", "|sum l (e - e_predicted)| / sum l e over filled nodes",
                   [](const Record& r) { return r.mismatch; }},
    RecordedScalar{"drift", "1", "sum l |e - e_predicted| / sum l e over filled nodes",
                   [](const Record& r) { return r.drift; }},
    RecordedScalar{"newton_iterations", "1", "of the network in the interval",
                   [](const Record& r) { return double(r.newton_iterations); }},
    RecordedScalar{"halvings", "1", "how often the network halved the interval",
                   [](const Record& r) { return double(r.halvings); }},
    RecordedScalar{"kinetic_energy", "J", "with the scaled mass",
                   [](const Record& r) { return r.kinetic_energy; }},
    RecordedScalar{"strain_energy", "J", "of the change from in situ",
                   [](const Record& r) { return r.strain_energy; }},
    RecordedScalar{"cohesive_work", "J", "spent on fracture faces so far",
                   [](const Record& r) { return r.cohesive_work; }},
    RecordedScalar{"failure_work", "J", "spent on damage and plastic flow of the rock so far",
                   [](const Record& r) { return r.failure_work; }},
    RecordedScalar{
        "cohesive_share", "1",
        "cohesive_work / (fracture energy times area of broken joints and half of other opened ones)",
        [](const Record& r) { return r.cohesive_share; }},
    RecordedScalar{"path_deviation", "m",
                   "greatest distance of the grown fracture from the line of the perforated slit",
                   [](const Record& r) { return r.path_deviation; }},
    RecordedScalar{"path_angle", "rad", "greatest over the wings: slit against chord from slit end to tip",
                   [](const Record& r) { return r.path_angle; }},
    RecordedScalar{"first_angle", "rad",
                   "greatest over the wings: first grown segment against greatest compression",
                   [](const Record& r) { return r.first_angle; }},
    RecordedScalar{"end_angle", "rad",
                   "greatest over the wings: last three segments against greatest compression",
                   [](const Record& r) { return r.end_angle; }},
    RecordedScalar{"greatest_slip", "m", "of the natural fractures",
                   [](const Record& r) { return r.natural_fractures.greatest_slip; }},
    RecordedScalar{"slipped_length", "m", "of natural fractures, slip above 1e-5 m",
                   [](const Record& r) { return r.natural_fractures.slipped_length; }},
    RecordedScalar{"opened_length", "m", "of natural fractures",
                   [](const Record& r) { return r.natural_fractures.opened_length; }},
    RecordedScalar{"wetted_length", "m", "of natural fractures, in the fracture network",
                   [](const Record& r) { return r.natural_fractures.wetted_length; }},
    RecordedScalar{"slip_distance", "m",
                   "greatest distance of a slipped joint from a hydraulic or open fracture",
                   [](const Record& r) { return r.natural_fractures.slip_distance; }},
    RecordedScalar{"greatest_far_slip", "m", "farther than ten tip sizes from any hydraulic or open fracture",
                   [](const Record& r) { return r.natural_fractures.greatest_far_slip; }},
    RecordedScalar{"meetings", "1", "of a hydraulic with a natural fracture so far",
                   [](const Record& r) { return double(r.meetings); }},
    RecordedScalar{"crossings", "1", "meetings at which the hydraulic fracture may cross",
                   [](const Record& r) { return double(r.crossings); }},
    RecordedScalar{"junction_pressure", "Pa", "greatest total pressure over the junctions of the network",
                   [](const Record& r) { return r.junction_pressure; }},
    RecordedScalar{"seismic_events", "1", "that can no longer change",
                   [](const Record& r) { return double(r.seismicity.events); }},
    RecordedScalar{"seismic_moment", "N m", "sum of the scalar moments of those events",
                   [](const Record& r) { return r.seismicity.seismic_moment; }},
    RecordedScalar{"greatest_moment", "N m", "scalar moment of the greatest of them",
                   [](const Record& r) { return r.seismicity.greatest_moment; }},
    RecordedScalar{"aseismic_moment", "N m", "sum of the scalar moments of aseismic sources",
                   [](const Record& r) { return r.seismicity.aseismic_moment; }},
    RecordedScalar{"transfer_moment", "N m",
                   "scalar moment that insertions changed in carrying the state over",
                   [](const Record& r) { return r.seismicity.transfer_moment; }},
    RecordedScalar{"source_moment_xx", "N m", "moment of all sources, seismic or not",
                   [](const Record& r) { return r.seismicity.source_moment[0]; }},
    RecordedScalar{"source_moment_yy", "N m", "moment of all sources, seismic or not",
                   [](const Record& r) { return r.seismicity.source_moment[1]; }},
    RecordedScalar{"source_moment_zz", "N m", "moment of all sources, seismic or not",
                   [](const Record& r) { return r.seismicity.source_moment[2]; }},
    RecordedScalar{"source_moment_xy", "N m", "moment of all sources, seismic or not",
                   [](const Record& r) { return r.seismicity.source_moment[3]; }},
    RecordedScalar{"elements", "1", "of the mesh", [](const Record& r) { return double(r.elements); }},
    RecordedScalar{"mass_scale", "1", "factor on the density", [](const Record& r) { return r.mass_scale; }},
    RecordedScalar{"stable_step", "s", "of the structure", [](const Record& r) { return r.stable_step; }},
};

}  // namespace

std::span<const RecordedScalar> recorded_scalars() {
  return columns;
}

std::optional<std::size_t> recorded_scalar_index(std::string_view name) {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const RecordedScalar& column) { return column.name == name; });
  if (found == columns.end()) return std::nullopt;
  return static_cast<std::size_t>(std::distance(columns.begin(), found));
}

}  // namespace fissura::coupler
