// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "common/case/case.hpp"
#include "common/case/table_reader.hpp"

/// One function per table of case.toml; `document` reads the whole document. Each reports what is wrong
/// within its own table, unknown keys included; what concerns several tables is left to check_case.
namespace fissura::input {

/// The files of a case: where they may lie, and which were read.
struct CaseFiles {
  std::filesystem::path folder;
  std::vector<std::filesystem::path> read;
};

// read_mesh.cpp
Domain read_domain(TableReader& document);
MeshControls read_mesh(TableReader& document);

// read_rock.cpp
Rock read_rock(TableReader& document);

// read_growth.cpp
BulkFailure read_failure(TableReader& document);
Growth read_growth(TableReader& document);

// read_in_situ.cpp
InSitu read_in_situ(TableReader& document);

// read_boundary.cpp
Boundaries read_boundary(TableReader& document);

// read_fractures.cpp
/// `rock` gives the defaults of intact lines.
std::vector<FractureLine> read_fractures(TableReader& document, const Rock& rock, CaseFiles& files);

// read_natural_faces.cpp
/// Strength and fracture energy of a line; those it has are the defaults.
void read_strength(TableReader& table, FractureLine& line);

/// Properties of the faces of natural fractures, and which of them were given and so are not to be taken from
/// others.
struct NaturalFaces {
  FractureLine line;
  bool friction_is_given = false;
  bool residual_aperture_is_given = false;
};

/// Those of a table that says nothing.
NaturalFaces unspecified_natural_faces();

enum class Friction { required, optional };

/// `table` laid over `before`.
NaturalFaces read_natural_faces(TableReader& table, const NaturalFaces& before, Friction friction);

/// Reports each of the keys of natural faces that `table` has.
void refuse_natural_faces(TableReader& table, const std::string& expected);

// read_natural_fractures.cpp
struct NaturalFractures {
  std::vector<NaturalFractureSet> sets;
  std::vector<FractureLine> traces;  ///< given one by one, of two points each
};
NaturalFractures read_natural_fractures(TableReader& document, const Domain& domain,
                                        const std::vector<FractureLine>& others, CaseFiles& files);

// read_injection.cpp
std::vector<Fluid> read_fluids(TableReader& document);
LeakOff read_leak_off(TableReader& document);
Injection read_injection(TableReader& document);

// read_controls.cpp
TimeSpan read_time(TableReader& document);
Coupling read_coupling(TableReader& document);
Dynamics read_dynamics(TableReader& document);
NetworkControls read_network(TableReader& document);
Output read_output(TableReader& document);
std::vector<InitialVelocity> read_initial_velocities(TableReader& document);
Deadlines read_deadlines(TableReader& document);
CheckpointControls read_checkpoint(TableReader& document);
PressureRange read_pressure_range(TableReader& document);

// read_seismicity.cpp
Seismicity read_seismicity(TableReader& document);
/// Nothing without the table.
std::optional<Georeference> read_georeference(TableReader& document);

// read_participants.cpp
Exchange read_exchange(TableReader& document);
Participants read_participants(TableReader& document);

}  // namespace fissura::input
