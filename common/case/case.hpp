// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// The typed case: what case.toml says, converted to SI, checked, and constant from then on.
///
/// Conventions. x points east, y north; the domain is centred on the origin. Stresses here are effective and
/// tension positive (case.toml states its own sign, see read_case.hpp). Pressures are positive in
/// compression. The model is plane strain of thickness `domain.thickness`; rates are those of the whole
/// thickness.
namespace fissura {

using Point = std::array<double, 2>;  ///< x, y [m]

struct TimeSpan {
  double end = 0;  ///< [s], > 0; a run begins at 0
};

struct Domain {
  double width = 0;      ///< extent in x [m]
  double height = 0;     ///< extent in y [m]
  double thickness = 0;  ///< out of plane [m]
};

/// A rectangle in which the mesh is at most this coarse.
struct Refinement {
  double size = 0;                                  ///< target edge length [m]
  double west = 0, east = 0, south = 0, north = 0;  ///< sides of the rectangle [m]
};

/// Target edge length: `fracture_size` within `corridor` of a fracture line, then growing by `gradation` per
/// metre of distance up to `far_size`. Around the tips of a fracture that grows freely the mesh is refined as
/// they arrive: `tip_size` within `tip_radius`, then growing by `tip_gradation` per metre.
struct MeshControls {
  double fracture_size = 0;  ///< h [m]
  double far_size = 0;       ///< [m]
  double corridor = 0;       ///< half width of the band of uniform size [m]
  double gradation = 0;      ///< [-], 0 < gradation <= 1
  std::uint64_t seed = 1;    ///< of the jitter of the interior points
  double tip_size = 0;       ///< h at a growing tip [m]; fracture_size by default
  double tip_radius = 0;     ///< [m]; 4 tip_size by default
  double tip_gradation = 0;  ///< [-]; 0.4 by default
  /// Direction of one of the three families of edges of a hexagonal lattice [rad], counter-clockwise from x.
  /// Without it the interior points are scattered by the seed.
  std::optional<double> lattice_angle;
  std::vector<Refinement> refinements;
  double natural_size = 0;  ///< h along natural fractures [m]; fracture_size by default
};

struct Rock {
  double density = 0;           ///< [kg/m3]
  double youngs_modulus = 0;    ///< E [Pa]
  double poissons_ratio = 0;    ///< nu [-]
  double tensile_strength = 0;  ///< f_t [Pa]
  double fracture_energy = 0;   ///< G_f [J/m2]
  double biot_coefficient = 1;  ///< alpha [-], of the rock; a fracture face carries the full fluid pressure
  double friction_coefficient = 0.6;  ///< tan(phi) of the faces of a new fracture [-]

  /// E' = E / (1 - nu^2) [Pa]
  [[nodiscard]] double plane_strain_modulus() const {
    return youngs_modulus / (1 - poissons_ratio * poissons_ratio);
  }
  /// G = E / (2 (1 + nu)) [Pa]
  [[nodiscard]] double shear_modulus() const { return youngs_modulus / (2 * (1 + poissons_ratio)); }
};

enum class Softening { linear, exponential };

/// Failure of the rock itself, away from fractures; without it the rock is elastic.
struct BulkFailure {
  bool active = false;
  Softening softening = Softening::exponential;
  double cohesion = 0;        ///< of the Mohr-Coulomb surface [Pa]; 0 = tension only
  double friction_angle = 0;  ///< phi [rad]
  double dilation_angle = 0;  ///< psi [rad], at most phi
  /// Laminated rock: strength across the bedding; Rock::tensile_strength is that along it [Pa]. Isotropic
  /// without.
  std::optional<double> strength_across_bedding;
  double bedding_angle = 0;  ///< direction of the bedding in the plane, counter-clockwise from x [rad]
  double tip_exclusion = 3;  ///< no damage starts within this many tip_size of an active tip [-]
};

enum class PathRule {
  prescribed,  ///< along the lines of kind intact
  free         ///< where the rock breaks; lines of kind intact are left out
};

/// Whether a hydraulic fracture that reaches a natural one goes on beyond it.
enum class CrossingRule {
  renshaw_pollard,  ///< Renshaw & Pollard 1995, in closed form for right angles
  gu_weng,          ///< its extension to any angle, Gu & Weng 2010
  blanton,          ///< Blanton 1986, from angle and stress difference
  always,
  never
};

enum class TipRule {
  insertion,  ///< a wet cohesive segment ahead of each tip whose averaged wet stress reaches a share of the
              ///< strength
  damage      ///< Profit et al. 2016: bulk damage first, then a segment along the failure path
};

/// How fractures grow.
struct Growth {
  PathRule path = PathRule::prescribed;
  TipRule tip = TipRule::insertion;
  double trigger = 0.65;                  ///< share of the tip strength at which a segment is inserted [-]
  double segment_length = 1;              ///< in tip_size [-]
  double turn_limit = 1.308996938995747;  ///< greatest turn of a segment [rad], 75 degrees
  bool nucleation = false;      ///< new fractures at failed clusters away from any tip; needs bulk failure
  double failure_damage = 0.7;  ///< damage at which an element counts as failed [-]
  /// Length of failure path that becomes a fracture, in tip_size [-]; tip = damage and nucleation.
  double failure_length = 2;
  /// Fluid pressure acts in damaged elements within this many tip_size of a tip [-]; tip = damage.
  double wet_zone = 2.5;
  CrossingRule crossing = CrossingRule::gu_weng;
};

/// Effective in-situ stress (tension positive) and pore pressure, linear in x and y, in equilibrium with
/// the body force at zero displacement:  div(stress) - alpha grad(pore_pressure) + density *
/// body_acceleration = 0.
struct InSitu {
  std::array<double, 4> stress{};                          ///< xx, yy, xy, zz at the origin [Pa]
  std::array<std::array<double, 2>, 4> stress_gradient{};  ///< d/dx, d/dy of each [Pa/m]
  double pore_pressure = 0;                                ///< at the origin [Pa]
  std::array<double, 2> pore_pressure_gradient{};          ///< [Pa/m]
  std::array<double, 2> body_acceleration{};               ///< [m/s2]
};

/// Pore pressure at a point [Pa].
double pore_pressure(const InSitu& in_situ, const Point& at);

/// Effective in-plane stress xx, yy, xy at a point, tension positive [Pa].
std::array<double, 3> in_plane_stress(const InSitu& in_situ, const Point& at);

enum class BoundaryKind {
  fixed,        ///< no displacement
  roller,       ///< no displacement normal to the side
  traction,     ///< total traction held at the in-situ value plus `value` [Pa] (x, y)
  displacement  ///< displacement `value` [m] (x, y), reached linearly at `ramp` [s]
};

struct Boundary {
  BoundaryKind kind = BoundaryKind::fixed;
  std::array<double, 2> value{};
  double ramp = 0;  ///< [s]
};

struct Boundaries {
  Boundary west, east, south, north;
};

enum class FractureKind {
  open,     ///< a slit without strength, connected to the fluid from the start
  natural,  ///< a frictional natural fracture
  intact    ///< intact rock that can break along this line (a prescribed path)
};

struct FractureLine {
  std::string name;
  FractureKind kind = FractureKind::open;
  std::vector<Point> points;    ///< polyline [m], at least two
  double tensile_strength = 0;  ///< [Pa]; of the rock for `intact`, of the cement (0 = none) for `natural`
  double fracture_energy = 0;   ///< [J/m2]; the same
  double friction_coefficient = 0;  ///< tan(phi) [-]
  double cohesion = 0;              ///< of the friction law [Pa]
  double dilation_angle = 0;        ///< psi of touching faces that slide [rad]; natural only, like the rest
  double dilation_slip = 0;         ///< slip beyond which they dilate no more [m]
  double residual_aperture = 0;     ///< hydraulic aperture of touching faces [m]
  double joint_compliance = 0;      ///< hydraulic opening of touching faces per fluid pressure [m/Pa]
  std::string set;  ///< the set of natural fractures it belongs to; empty if it is given by itself
};

/// A quantity that scatters: normal distribution, cut at three deviations and where it would not be positive.
struct Scattered {
  double mean = 0, deviation = 0;
};

enum class PersistenceReading {
  repeat,  ///< distance along strike from the begin of one trace to the begin of the next
  gap      ///< distance along strike from the end of one trace to the begin of the next
};

/// A set of natural fractures, from which traces are drawn (natural_fractures.hpp). Lengths in m, angles in
/// rad.
struct NaturalFractureSet {
  std::string name;
  Scattered orientation;  ///< azimuth of the strike, from north (y), clockwise
  Scattered spacing;      ///< across strike
  Scattered length;       ///< of a trace
  Scattered persistence;
  PersistenceReading reading = PersistenceReading::repeat;
  std::uint64_t seed = 1;
  double west = 0, east = 0, south = 0, north = 0;  ///< the region they fill
  FractureLine faces;                               ///< properties that each trace gets; no points
};

/// tau = K gamma^n; Newtonian for n = 1 with K the viscosity.
struct Fluid {
  std::string name;
  double consistency_index = 0;  ///< K [Pa s^n]
  double power_index = 1;        ///< n [-]
  double bulk_modulus = 0;       ///< K_f [Pa]
};

struct LeakOff {
  double coefficient = 0;   ///< C_l of ONE face [m/s^0.5]
  double spurt_volume = 0;  ///< S_p of one face [m3/m2]
};

struct Perforation {
  std::string name;
  Point position{};     ///< [m]; must lie on an open fracture
  double aperture = 0;  ///< hydraulic aperture e_0 stored there at the start [m]
};

enum class StageControl { rate, pressure, shut_in };

/// One stage of the pumping schedule; it lasts until the next begins. All perforations share one well
/// pressure.
struct Stage {
  double begin = 0;  ///< [s]
  StageControl control = StageControl::rate;
  double rate = 0;      ///< of all perforations together, whole thickness [m3/s]; for control = rate
  double pressure = 0;  ///< total well pressure [Pa]; for control = pressure
  double ramp = 0;      ///< time in which the value is reached linearly from that of the stage before [s]
  std::string fluid;    ///< name of the injected fluid; empty for shut_in
};

/// Without perforations the case is dry: no fluid is pumped and no fracture holds any.
struct Injection {
  std::vector<Perforation> perforations;
  std::vector<Stage> stages;
  double well_index = 0;  ///< WI of one perforation, per unit thickness [m2/(s Pa)]: q = WI (p_w - p)
};

enum class CouplingScheme { robin, profit2016 };

struct Coupling {
  CouplingScheme scheme = CouplingScheme::robin;
  int minimum_steps = 10;                ///< explicit steps of a coupling interval, lower limit
  int maximum_steps = 20;                ///< upper limit
  double front_fraction = 0.02;          ///< an interval is at most this times h / tip speed
  double drift_tolerance = 1e-3;         ///< eta of the interval rule [-]
  double compliance_factor = 0.3;        ///< share of the static interface compliance used; see
                                         ///< docs/decisions/0001-robin-robin-coupling.md [-]
  double maximum_interval = 0;           ///< [s]; 0 = no further limit
  double fracture_normal_stiffness = 0;  ///< K_n [Pa/m] of profit2016; 0 = rigid
};

struct Dynamics {
  double damping = 0.2;              ///< Cundall local damping lambda [-]
  double safety_factor = 0.8;        ///< of the stable step [-]
  double loading_ratio = 0.05;       ///< beta of the staged mass scaling [-]
  double event_loading_ratio = 0.2;  ///< beta_e after a change of the pumping [-]
  double initial_mass_scale = 100;   ///< [-], >= 1
  double maximum_mass_scale = 1e8;   ///< [-]
  bool equilibrate = true;  ///< let natural fractures come to rest under the in-situ stress before time 0,
                            ///< and count slip from there
};

/// A rectangle of the rock that moves at time 0.
struct InitialVelocity {
  std::array<double, 2> velocity{};                 ///< x, y [m/s]
  double west = 0, east = 0, south = 0, north = 0;  ///< sides of the rectangle [m]
};

/// A point whose stress and displacement, and those of the nearest joint within one element, are recorded at
/// every coupling time.
struct Probe {
  std::string name;
  Point position{};  ///< [m]
};

struct NetworkControls {
  double minimum_aperture = 1e-5;  ///< floor of the aperture in the conductivity only [m]
  double tolerance = 1e-10;        ///< of the Newton residual, relative to the content moved [-]
  int maximum_iterations = 100;
};

struct Output {
  double interval = 0;           ///< simulated time between field reports [s]
  int reports_per_segment = 20;  ///< field reports in one HDF5 segment
  std::vector<Probe> probes;
};

/// The length out of the plane with which the moment of a seismic event is formed.
enum class SourceThickness {
  layer,           ///< domain.thickness
  equidimensional  ///< the length of the event in the plane
};

/// How failures become seismic events; docs/microseismicity.md. Zero stands for what the mesh gives.
struct Seismicity {
  bool active = true;         ///< the structure tells of sources
  double slip_rate = 1e-3;    ///< v_s: contact that moves slower is aseismic [m/s]
  double stress_drop = 1e4;   ///< contact that loses less shear traction is aseismic [Pa]
  double failure_rate = 0;    ///< rock and cohesion that open slower are aseismic [m/s]; 0: none of it is
  double cluster_radius = 0;  ///< r_c [m]; 0 = 1.5 element sizes
  double cluster_time = 0;    ///< t_c [s]; 0 = r_c over the speed of shear waves in the scaled mass
  double rest_time = 0;       ///< longest pause within one source [s]; 0 = 100 t_c
  SourceThickness thickness = SourceThickness::layer;
  int maximum_records = 100000;  ///< of one interval; more are merged, none is dropped
  double voxel_size = 10;        ///< edge of the cells in which the stimulated volume is counted [m]
  int voxel_events = 1;          ///< fewest events of a stimulated cell
};

/// Where on Earth the model lies; QuakeML cannot do without.
struct Georeference {
  double latitude = 0, longitude = 0;  ///< of the origin of the model [degree]
  double depth = 0;                    ///< of the origin, positive down [m]
  std::string start;                   ///< time 0 in UTC, "2026-01-31T12:00:00Z"
  double azimuth = 0;                  ///< of the y axis, clockwise from north [rad]
  /// A vertical section: x points along this azimuth [rad] and y up. Without it the model is a plan view.
  std::optional<double> section_azimuth;
};

/// Nobody waits longer than this. Wall time, seconds.
struct Deadlines {
  double join = 10;      ///< from the start of a participant to its HELLO, and for the mesh
  double progress = 10;  ///< a participant at work without any progress
  double finish = 10;    ///< from FINISH to the end of the process
};

/// When a run keeps a checkpoint; all three are consistent at a coupling time.
struct CheckpointControls {
  double interval = 60;          ///< wall time between two [s]; 0: none by the clock
  int intervals = 0;             ///< coupling intervals between two; 0: none by their number
  int keep = 2;                  ///< newest ones kept, at least 2
};

/// Range outside which an exchanged pressure is refused. [Pa]
struct PressureRange {
  double minimum = 0;
  double maximum = 1e9;
};

/// How the participants reach the coupler: "ipc" (a socket in the run's own directory) or a loopback TCP
/// endpoint.
struct Exchange {
  std::string endpoint = "ipc";
};

/// Which solver plays a role.
struct Participants {
  std::string network = "fissura";
};

struct Case {
  int schema = 1;
  std::string title;
  TimeSpan time;
  Domain domain;
  MeshControls mesh;
  Rock rock;
  BulkFailure bulk_failure;
  Growth growth;
  InSitu in_situ;
  Boundaries boundary;
  /// With the traces of the sets, cleaned; may be empty in a case without injection.
  std::vector<FractureLine> fractures;
  std::vector<NaturalFractureSet> natural_fracture_sets;  ///< what they were drawn from
  std::vector<InitialVelocity> initial_velocities;
  std::vector<Fluid> fluids;
  LeakOff leak_off;
  Injection injection;
  Coupling coupling;
  Dynamics dynamics;
  NetworkControls network;
  Output output;
  Seismicity seismicity;
  std::optional<Georeference> georeference;
  Deadlines deadlines;
  CheckpointControls checkpoint;
  PressureRange pressure_range;
  Exchange exchange;
  Participants participants;
};

/// Effective tensile strength at element size h: the strength is lowered, never the energy, where the
/// cohesive zone would be shorter than the mesh can carry.
///   f_t,tip = min(f_t, sqrt(E' G_f / (1.5 h)))   [Pa]
double tip_strength(double tensile_strength, double fracture_energy, double plane_strain_modulus, double h);

}  // namespace fissura
