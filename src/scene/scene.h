// The scene: everything that a run is told, as plain data. SI units. Tests build it here, in C++; describe.h gives
// the key, range and meaning of each field.
//
// A vector has three components whatever the dimension; in 2D, z is 0 and is neither read nor written.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/types.h"
#include "frame/quantities.h"

namespace weir {

// ---- shapes -------------------------------------------------------------------------------------------------------

struct Box {
  Vec3 min{0};  // m
  Vec3 max{0};  // m
};
struct Ball {  // a disc in 2D
  Vec3 center{0};
  double radius = 0;  // m
};
struct Polygon {             // 2D only; simple, in either sense of rotation
  std::vector<Vec3> points;  // m
};
using Shape = std::variant<Box, Ball, Polygon>;

// ---- fluid --------------------------------------------------------------------------------------------------------

struct TaylorGreen {       // decaying vortices, periodic along x and y
  double speed = 0;        // m/s, the largest
  double wave_length = 0;  // m
  Vec3 phase_origin{0};    // m, where the phase is zero; not in files: relative_to() keeps the phase by it
};
struct Flow {  // named velocity fields
  std::optional<TaylorGreen> taylor_green{};
};

enum class StartPressure { none, hydrostatic };  // hydrostatic: of a column at rest below the top of its volume

struct Volume {
  Shape shape;
  Vec3 velocity{0};                              // m/s at the start
  Vec3 angular_velocity{0};                      // rad/s about the shape's centre at the start; 2D: z alone
  Flow flow{};                                   // added to these
  double perturbation = 0;                       // dx; each particle is moved by up to this along each axis
  StartPressure pressure = StartPressure::none;  // of methods that carry a density
};

enum class ViscosityModel { none, morris, monaghan, hinsch2024 };
struct Viscosity {
  ViscosityModel model = ViscosityModel::morris;
  double kinematic = 1.0e-6;  // m^2/s
};

enum class SurfaceTensionModel { none, hinsch2024 };
struct SurfaceTension {
  SurfaceTensionModel model = SurfaceTensionModel::none;
  double coefficient = 0;  // s of [Hinsch24 Alg. 2], m^(d+2)/s^2
};

struct Fluid {
  double rest_density = 1000;  // kg/m^3
  Viscosity viscosity;
  SurfaceTension surface_tension;
  std::vector<Volume> volumes;
};

// ---- walls --------------------------------------------------------------------------------------------------------

enum class Side {
  left,
  right,
  bottom,
  top,
  front,
  back
};  // -x, +x, -y, +y; in 3D -y, +y are front, back and -z, +z bottom, top

struct Tank {  // a container: layers grow outwards from the faces of [min, max]
  Vec3 min{0};
  Vec3 max{0};
  std::vector<Side> open;  // faces left out
};
struct Block {  // a solid box: layers grow inwards from its faces
  Vec3 min{0};
  Vec3 max{0};
};
enum class Flank { left, right };  // of a line, seen along it
struct Polyline {                  // 2D only: the fluid touches the line itself, layers grow to one flank
  std::vector<Vec3> points;
  bool closed = false;
  Flank solid = Flank::right;  // where the layers are
};
enum class Face { inside, outside };
struct Round {  // a disc in 2D, a ball in 3D
  Vec3 center{0};
  double radius = 0;
  Face solid = Face::inside;  // inside: an obstacle; outside: a container
};
struct PolygonWall {  // 2D only; simple, in either sense of rotation
  std::vector<Vec3> points;
  Face solid = Face::inside;  // as of Round
};
using WallShape = std::variant<Tank, Block, Polyline, Round, PolygonWall>;

struct Wall {
  WallShape shape;
  int layers = 0;            // 0: as many as fill the support, ceil(support_radius / dx)
  std::vector<Shape> holes;  // regions where this wall is left out
  Vec3 slide{0};             // m/s; the surface slides along itself (a lid, a belt), positions stay
};

// ---- domain -------------------------------------------------------------------------------------------------------

enum class Axis { x, y, z };

// ---- solver -------------------------------------------------------------------------------------------------------

enum class Method { wcsph, delta_sph };
enum class KernelName { cubic_spline, wendland_c2, wendland_c4 };
struct Kernel {
  KernelName name = KernelName::cubic_spline;
  double smoothing = 1.0;  // h / dx
};
enum class NegativePressure { clamp, keep };  // clamp: p < 0 becomes 0, as a free surface needs (erratum A3)
enum class WallSlip { no_slip, free_slip };   // whether viscosity acts between fluid and walls
enum class WallPressure {
  mirrored,
  extrapolated
};  // of wall particles: the fluid particle's own, or from the fluid around

struct FixedStep {
  double dt = 0;  // s, an upper bound: steps land on frame times, the interval before is divided evenly
};
struct AdaptiveStep {
  double cfl = 0.4;        // dt <= cfl h / v_max
  double acoustic = 1.0;   // dt <= acoustic h / max (c + v)
  double force = 0.25;     // dt <= force sqrt(h / a_max)
  double viscous = 0.125;  // dt <= viscous h^2 / nu
  double maximum = 0;      // s; 0: no other bound
};
using TimeStep = std::variant<AdaptiveStep, FixedStep>;

struct Stiffness {
  double k = 1.0e5;  // Pa, of p = k ((rho/rho0)^exponent - 1)
};
struct SoundSpeed {
  double c0 = 0;  // m/s; k = rho0 c0^2 / exponent
};
using Compressibility = std::variant<Stiffness, SoundSpeed>;

struct Solver {
  Method method = Method::wcsph;
  double density_diffusion = 0.1;  // strength delta of the density diffusion of delta_sph
  Kernel kernel;
  Compressibility compressibility;
  int exponent = 7;  // 7: Tait [Hinsch24 ch. 4.4]; 1: linear
  NegativePressure negative_pressure = NegativePressure::clamp;
  WallSlip wall_slip = WallSlip::no_slip;
  WallPressure wall_pressure = WallPressure::mirrored;
  TimeStep time_step;
};

// ---- timeline -----------------------------------------------------------------------------------------------------

// Parameters that a timeline can change during a run.
struct Parameters {
  Vec3 gravity{0};             // m/s^2
  double viscosity = 0;        // nu, m^2/s
  double surface_tension = 0;  // s of [Hinsch24 Alg. 2], m^(d+2)/s^2
  double stiffness = 0;        // k, Pa
};
// One change of them; unset ones stay. settings.h describes each.
struct Settings {
  std::optional<Vec3> gravity{};
  std::optional<double> viscosity{};        // fluid.viscosity.kinematic
  std::optional<double> surface_tension{};  // fluid.surface_tension.coefficient
  std::optional<double> stiffness{};        // solver.stiffness
  std::optional<double> sound_speed{};      // solver.sound_speed
};
struct TimelineEvent {
  double at = 0;    // s of run time
  double over = 0;  // s; 0: at once, else a linear ramp of this length
  Settings set{};
  bool reset = false;           // particles return to their initial state; settings stay
  std::optional<bool> pause{};  // true: the movie holds; false: goes on
};

// ---- camera and pictures ------------------------------------------------------------------------------------------

struct View2D {
  Vec3 center{0};
  double width = 1;  // m, visible across the picture
};
struct View3D {
  Vec3 eye{0};
  Vec3 target{0};
  double field_of_view = 35;  // degrees, vertical
};
struct AutoView {};  // all fluid and walls, fitted once
using View = std::variant<AutoView, View2D, View3D>;
struct CameraKeyframe {
  double at = 0;  // s of run time
  View view;      // never AutoView
};
struct Camera {
  View view;
  std::vector<CameraKeyframe> keyframes;  // with any, `view` is unused; smooth in between, still before and after
};

enum class ColormapName { viridis, cividis, magma, turbo, coolwarm };
struct Coloring {
  Quantity by = Quantity::speed;
  ColormapName map = ColormapName::viridis;
  std::optional<std::array<double, 2>> range;  // in the quantity's unit; none: estimated from the scene before frame 0
};
enum class OverlayItem { title, time, colorbar, scalebar, cfl };
enum class Theme { light, dark };

struct Render {
  std::array<int, 2> size{1920, 1080};  // pixels, even
  int fps = 60;
  Coloring color;
  std::vector<OverlayItem> overlay{OverlayItem::title, OverlayItem::time, OverlayItem::colorbar, OverlayItem::scalebar,
                                   OverlayItem::cfl};
  Theme theme = Theme::light;
  bool transparent = false;  // PNG only: no background
  bool walls = true;
};

// ---- output -------------------------------------------------------------------------------------------------------

struct Movie {
  std::string encoder = "auto";      // libav's name; auto: libx264, else what is there
  int quality = 20;                  // rate factor, 0 (the best that profile High can) .. 51
  std::string preset = "ultrafast";  // the encoder's speed preset
};
struct Log {
  double every = 0.01;  // s
};
// A quantity in a particle file. A type of its own, since Names<Quantity> has only those that colour.
enum class ParticleField : int {};
constexpr ParticleField field_of(Quantity quantity) { return static_cast<ParticleField>(quantity); }
constexpr Quantity quantity_of(ParticleField field) { return static_cast<Quantity>(field); }
struct ParticleFiles {
  double every = 0;  // s; 0: at every frame time
  std::vector<ParticleField> fields{field_of(Quantity::velocity), field_of(Quantity::density),
                                    field_of(Quantity::pressure), field_of(Quantity::id)};
};
struct Output {
  std::optional<Movie> movie = Movie{};
  bool frames = false;
  std::vector<double> stills;  // s; frame times
  Log log;
  std::optional<ParticleFiles> particles{};
};

struct Scene {
  std::string name;  // names the run folder and the movie; by default the file's, without folder and ending
  std::string title;
  int dimension = 2;
  double duration = 0;          // s of run time
  Vec3 gravity{0, -9.81, 0};    // m/s^2; default downwards, -y in 2D and -z in 3D
  double particle_spacing = 0;  // dx, m
  Fluid fluid;
  std::vector<Wall> walls;
  std::vector<Axis> periodic;    // particles that leave at one end enter at the other
  std::optional<Bounds> domain;  // m; along periodic axes, else without meaning
  Solver solver;
  std::vector<TimelineEvent> timeline;
  Camera camera;
  Render render;
  Output output;
};

// ---- derived quantities -------------------------------------------------------------------------------------------

double smoothing_length(const Scene& scene);            // h, m
double support_radius(const Scene& scene);              // 2 h for both kernels, m
double particle_mass(const Scene& scene);               // rho0 dx^d, kg (per metre of depth in 2D)
int wall_layers(const Scene& scene, const Wall& wall);  // resolves the default
std::int64_t last_frame(const Scene& scene);            // floor(duration fps): frames are 0 .. last_frame
double stiffness(const Scene& scene);                   // k, Pa
double sound_speed(const Scene& scene);                 // c0 = sqrt(exponent k / rho0), m/s
Parameters initial_parameters(const Scene& scene);
double max_speed_estimate(const Scene& scene);  // m/s, from initial speeds, gravity and the height it can act over
bool holds_fluid(const Scene& scene);           // whether walls have a velocity that viscosity meets
bool draws(const Scene& scene);                 // whether any picture is asked for
bool is_periodic(const Scene& scene, int axis);
// The period, m: the domain's extent if it is given, else that of fluid volumes and walls' shapes without their layers.
// Has a meaning along periodic axes only.
Bounds periodic_extent(const Scene& scene);

}  // namespace weir
