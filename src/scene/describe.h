// The field table: key, unit, range and meaning of each field of scene.h; defaults are those of the structs. Reader, writer, schema and reference are visitors over this one table and so cannot disagree.
//
// A visitor has
//   field(key, value, spec)            a leaf: number, word, vector, list of those
//   group(key, meaning, describer)     a map of fixed keys
//   list(key, values, meaning)         a list of maps, each described by describe()
//   one_of(variant, more, Named...)    exactly one of several keys, each a map; `more` adds keys to that map
//   one_field_of(variant, Leaf...)     at most one of several leaves; the first is the default
//   forms(key, variant, meaning, ...)  a value that is a Word, or a Map of one kind or another
//   by_dimension(variant, Map...)      keys that depend on the dimension, beside the others
//   toggle(key, optional, meaning)     true, false or a map
//   option(key, optional, meaning)     a map that may be left out
//   version(key, number)               the format version
//   not_built(key, empty, meaning)     a reserved key, of which only the empty form is accepted
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "scene/settings.h"
#include "scene/spec.h"

namespace weir {

inline constexpr int format_version = 1;

inline Vec3 default_gravity(int dimension) { return dimension == 3 ? Vec3(0, 0, -9.81) : Vec3(0, -9.81, 0); }

// ---- shapes -------------------------------------------------------------------------------------------------------

template <class V>
void describe(V& v, Box& box) {
  v.field("min", box.min, Spec{.meaning = "lower corner", .unit = "m", .required = true});
  v.field("max", box.max, Spec{.meaning = "upper corner", .unit = "m", .required = true});
}

template <class V>
void describe(V& v, Ball& ball) {
  v.field("center", ball.center, Spec{.meaning = "centre", .unit = "m", .required = true});
  v.field("radius", ball.radius, Spec{.meaning = "radius", .unit = "m", .range = positive, .required = true});
}

template <class V>
void describe(V& v, Polygon& polygon) {
  v.field("points", polygon.points,
          Spec{.meaning = "corners in order, in either sense", .unit = "m", .required = true, .least = 3});
}

template <class V, class More>
void describe_shape(V& v, Shape& shape, More more) {
  v.one_of(shape, more, Named<Box>{"box", "a box along the axes"}, Named<Ball>{"disc", "a disc (2D)", 2},
           Named<Ball>{"ball", "a ball (3D)", 3}, Named<Polygon>{"polygon", "a simple polygon (2D)", 2});
}

template <class V>
void describe(V& v, Shape& shape) {
  describe_shape(v, shape, [](auto&) {});
}

// ---- fluid --------------------------------------------------------------------------------------------------------

template <class V>
void describe(V& v, TaylorGreen& flow) {
  v.field("speed", flow.speed, Spec{.meaning = "largest speed U", .unit = "m/s", .required = true});
  v.field("wave_length", flow.wave_length,
          Spec{.meaning = "wave length L", .unit = "m", .range = positive, .required = true});
}

template <class V>
void describe(V& v, Volume& volume) {
  describe_shape(v, volume.shape, [](auto&) {});
  v.field("velocity", volume.velocity, Spec{.meaning = "velocity at the start", .unit = "m/s"});
  v.field("angular_velocity", Spin{volume.angular_velocity},
          Spec{.meaning = "rotation about the shape's centre at the start, added to the velocity; a number in 2D, a "
                          "vector in 3D",
               .unit = "rad/s"});
  v.group("flow", "velocity field at the start, added to the velocity", [&](auto& sub) {
    sub.option("taylor_green", volume.flow.taylor_green,
               "u = -U cos(2 pi x / L) sin(2 pi y / L), v = U sin(2 pi x / L) cos(2 pi y / L)");
  });
  v.field(
      "perturbation", volume.perturbation,
      Spec{.meaning = "each particle is moved at the start by up to so many spacings along each axis, at random but "
                      "the same in every run",
           .unit = "1",
           .range = {0, 0.3}});
  v.field("pressure", volume.pressure,
          Spec{.meaning = "pressure at the start, of delta_sph; hydrostatic: of a column at rest below the top of this "
                          "volume"});
}

template <class V>
void describe(V& v, Viscosity& viscosity) {
  v.field("model", viscosity.model,
          Spec{.meaning = "form of the viscous term; hinsch2024 is the printed form, kept for comparison"});
  v.field("kinematic", viscosity.kinematic, viscosity_spec);
}

template <class V>
void describe(V& v, SurfaceTension& tension) {
  v.field("model", tension.model, Spec{.meaning = "form of the cohesion between fluid particles"});
  v.field("coefficient", tension.coefficient, surface_tension_spec);
}

template <class V>
void describe(V& v, Fluid& fluid) {
  v.field("rest_density", fluid.rest_density,
          Spec{.meaning = "density at zero pressure", .unit = "kg/m^3", .range = positive});
  v.group("viscosity", "viscous force", [&](auto& sub) { describe(sub, fluid.viscosity); });
  v.group("surface_tension", "surface tension", [&](auto& sub) { describe(sub, fluid.surface_tension); });
  v.list("volumes", fluid.volumes,
         Spec{.meaning = "shapes that are filled with fluid at the start", .required = true, .least = 1});
}

// ---- walls --------------------------------------------------------------------------------------------------------

template <class V>
void describe(V& v, Tank& tank) {
  v.field("min", tank.min, Spec{.meaning = "lower corner of the inside", .unit = "m", .required = true});
  v.field("max", tank.max, Spec{.meaning = "upper corner of the inside", .unit = "m", .required = true});
  v.field("open", tank.open, Spec{.meaning = "sides left out"});
}

template <class V>
void describe(V& v, Block& block) {
  v.field("min", block.min, Spec{.meaning = "lower corner", .unit = "m", .required = true});
  v.field("max", block.max, Spec{.meaning = "upper corner", .unit = "m", .required = true});
}

template <class V>
void describe(V& v, Polyline& line) {
  v.field(
      "points", line.points,
      Spec{
          .meaning = "corners in order; the fluid touches the line itself", .unit = "m", .required = true, .least = 2});
  v.field("closed", line.closed, Spec{.meaning = "whether the last point joins the first"});
  v.field("solid", line.solid, Spec{.meaning = "the side of the line on which the wall is, seen along it"});
}

template <class V>
void describe(V& v, Round& round) {
  v.field("center", round.center, Spec{.meaning = "centre", .unit = "m", .required = true});
  v.field("radius", round.radius, Spec{.meaning = "radius", .unit = "m", .range = positive, .required = true});
  v.field("solid", round.solid, Spec{.meaning = "inside: an obstacle; outside: a container"});
}

template <class V>
void describe(V& v, PolygonWall& polygon) {
  v.field("points", polygon.points,
          Spec{.meaning = "corners in order, in either sense; the fluid touches the outline itself",
               .unit = "m",
               .required = true,
               .least = 3});
  v.field("solid", polygon.solid, Spec{.meaning = "inside: an obstacle; outside: a container"});
}

template <class V>
void describe(V& v, Wall& wall) {
  const auto common = [&](auto& sub) {
    sub.field(
        "layers", OrWord<int>{wall.layers, 0, "auto"},
        Spec{.meaning = "layers of wall particles; auto: as many as fill the kernel's support", .range = {1, 100}});
    sub.list("holes", wall.holes, Spec{.meaning = "shapes, as in fluid.volumes, where this wall is left out"});
    sub.group("motion", "how the wall moves", [&](auto& motion) {
      motion.field("slide", wall.slide,
                   Spec{.meaning = "velocity with which the surface slides along itself, as a lid or a belt does; "
                                   "positions stay",
                        .unit = "m/s"});
    });
  };
  v.one_of(wall.shape, common, Named<Tank>{"tank", "a container: layers grow outwards from its faces"},
           Named<Block>{"box", "a solid box: layers grow inwards from its faces"},
           Named<Polyline>{"polyline", "a line of straight pieces (2D): layers grow to one side", 2},
           Named<Round>{"disc", "a disc, solid or hollow (2D)", 2},
           Named<Round>{"ball", "a ball, solid or hollow (3D)", 3},
           Named<PolygonWall>{"polygon", "a simple polygon, solid or hollow (2D)", 2});
  v.not_built("plane", EmptyForm::none, "a wall without particles");
}

// ---- domain -------------------------------------------------------------------------------------------------------

template <class V>
void describe(V& v, Bounds& box) {
  v.field("min", box.min, Spec{.meaning = "lower corner", .unit = "m", .required = true});
  v.field("max", box.max, Spec{.meaning = "upper corner", .unit = "m", .required = true});
}

// ---- solver -------------------------------------------------------------------------------------------------------

template <class V>
void describe(V& v, Kernel& kernel) {
  v.field("name", kernel.name, Spec{.meaning = "smoothing kernel; its support is 2 h"});
  v.field("smoothing", kernel.smoothing,
          Spec{.meaning = "smoothing length over particle spacing, h / dx", .unit = "1", .range = {0.5, 4}});
}

template <class V>
void describe(V& v, AdaptiveStep& step) {
  constexpr Range factor{0, 10, true};
  v.field("cfl", step.cfl, Spec{.meaning = "dt <= cfl h / v_max", .unit = "1", .range = factor});
  v.field(
      "acoustic", step.acoustic,
      Spec{
          .meaning =
              "dt <= acoustic h / (c + v), of the particle with the largest c + v; c is the sound speed at its density",
          .unit = "1",
          .range = factor});
  v.field("force", step.force,
          Spec{.meaning = "dt <= force sqrt(h / a_max), a_max the largest acceleration", .unit = "1", .range = factor});
  v.field("viscous", step.viscous,
          Spec{.meaning = "dt <= viscous h^2 / nu, nu the kinematic viscosity, with monaghan three times it",
               .unit = "1",
               .range = factor});
  v.field("maximum", OrWord<double>{step.maximum, 0, "none"},
          Spec{.meaning = "dt is never longer than this", .unit = "s", .range = positive});
}

template <class V>
void describe(V& v, FixedStep& step) {
  v.field("fixed", step.dt,
          Spec{.meaning = "time step, in place of the limits; shortened evenly to land on frame times",
               .unit = "s",
               .range = positive,
               .required = true});
}

template <class V>
void describe(V& v, Solver& solver) {
  v.field("method", solver.method, Spec{.meaning = "pressure solver"});
  v.field("density_diffusion", solver.density_diffusion,
          Spec{.meaning = "delta_sph: strength delta of the density diffusion", .unit = "1", .range = not_negative});
  v.group("kernel", "smoothing kernel", [&](auto& sub) { describe(sub, solver.kernel); });
  v.one_field_of(solver.compressibility, Leaf<Stiffness>{"stiffness", &Stiffness::k, stiffness_spec},
                 Leaf<SoundSpeed>{"sound_speed", &SoundSpeed::c0, sound_speed_spec});
  v.field("exponent", solver.exponent,
          Spec{.meaning = "of the state equation; 7 is Tait's, 1 the linear one", .unit = "1", .range = {1, 7}});
  v.field("negative_pressure", solver.negative_pressure,
          Spec{.meaning = "clamp: tension becomes zero pressure, as a free surface needs"});
  v.field("wall_slip", solver.wall_slip, Spec{.meaning = "whether walls exert viscous force: no_slip they do"});
  v.field("wall_pressure", solver.wall_pressure,
          Spec{.meaning = "pressure of wall particles. mirrored: that of the fluid particle itself; extrapolated: from "
                          "the fluid around them"});
  v.forms("time_step", solver.time_step, "limits of an adaptive time step, or {fixed: dt}", Map<AdaptiveStep>{},
          Map<FixedStep>{});
}

// ---- timeline -----------------------------------------------------------------------------------------------------

template <class V>
void describe(V& v, Settings& set) {
  for_each_setting([&](const auto& row) { v.field(row.key, set.*row.value, row.spec); });
}

template <class V>
void describe(V& v, TimelineEvent& event) {
  v.field("at", event.at, Spec{.meaning = "when, in run time", .unit = "s", .range = not_negative, .required = true});
  v.field(
      "over", event.over,
      Spec{.meaning = "length of the linear ramp to the new settings; 0: at once", .unit = "s", .range = not_negative});
  v.group("set", "settings from then on", [&](auto& sub) { describe(sub, event.set); });
  v.field("reset", event.reset, Spec{.meaning = "particles return to their initial state; settings stay"});
  v.field("pause", event.pause, Spec{.meaning = "true: the movie holds; false: it goes on"});
}

// ---- camera and pictures ------------------------------------------------------------------------------------------

template <class V>
void describe(V& v, View2D& view) {
  v.field("center", view.center, Spec{.meaning = "centre of the visible region (2D)", .unit = "m", .required = true});
  v.field("width", view.width,
          Spec{.meaning = "width of the visible region (2D)", .unit = "m", .range = positive, .required = true});
}

template <class V>
void describe(V& v, View3D& view) {
  v.field("eye", view.eye, Spec{.meaning = "position of the camera (3D)", .unit = "m", .required = true});
  v.field("target", view.target, Spec{.meaning = "point that it looks at (3D)", .unit = "m", .required = true});
  v.field("field_of_view", view.field_of_view,
          Spec{.meaning = "vertical opening angle (3D)", .unit = "degrees", .range = {1, 170}});
}

template <class V>
void describe(V& v, CameraKeyframe& keyframe) {
  v.field("at", keyframe.at,
          Spec{.meaning = "when, in run time", .unit = "s", .range = not_negative, .required = true});
  v.by_dimension(keyframe.view, Map<View2D>{2}, Map<View3D>{3});
}

template <class V>
void describe(V& v, Camera& camera) {
  v.forms("view", camera.view, "auto: all fluid and walls, fitted once; or a fixed view", Word<AutoView>{"auto"},
          Map<View2D>{2}, Map<View3D>{3});
  v.list("keyframes", camera.keyframes,
         Spec{.meaning = "views over time, in place of `view`; smooth in between, still before and after"});
}

template <class V>
void describe(V& v, Coloring& color) {
  v.field("by", color.by,
          Spec{.meaning = "quantity that colours the fluid; id and volume number its particles and volumes from 0"});
  v.field("map", color.map, Spec{.meaning = "colour map"});
  v.field(
      "range", AutoRange{color.range},
      Spec{.meaning = "ends of the colour map, in the SI unit of the quantity; auto: estimated from the scene, never "
                      "changed"});
}

template <class V>
void describe(V& v, Render& render) {
  v.field("size", render.size,
          Spec{.meaning = "width and height of pictures, even", .unit = "pixels", .range = {16, 16384}, .multiple = 2});
  v.field("fps", render.fps, Spec{.meaning = "pictures per second of run time", .unit = "1/s", .range = {1, 1000}});
  v.group("color", "colours of the fluid", [&](auto& sub) { describe(sub, render.color); });
  v.field("overlay", render.overlay, Spec{.meaning = "items drawn over the picture"});
  v.field("theme", render.theme, Spec{.meaning = "background and text"});
  v.field("transparent", render.transparent, Spec{.meaning = "PNG files without background; movies keep theirs"});
  v.field("walls", render.walls, Spec{.meaning = "whether walls are drawn"});
}

// ---- output -------------------------------------------------------------------------------------------------------

template <class V>
void describe(V& v, Movie& movie) {
  v.field("encoder", movie.encoder,
          Spec{.meaning = "H.264 encoder by its libav name; auto: libx264, else another one that is installed"});
  v.field("quality", movie.quality,
          Spec{.meaning = "rate factor, for `ultrafast` a quantiser 5 above it; 0 is the best, more is smaller",
               .unit = "1",
               .range = {0, 51}});
  v.field("preset", movie.preset, Spec{.meaning = "speed preset of the encoder"});
}

template <class V>
void describe(V& v, ParticleFiles& particles) {
  v.field(
      "every", OrWord<double>{particles.every, 0, "frame"},
      Spec{.meaning = "run time between files, each at the first step at or after it; frame: one at each frame time",
           .unit = "s",
           .range = positive});
  v.field("fields", particles.fields, Spec{.meaning = "quantities beside the positions"});
}

template <class V>
void describe(V& v, Output& output) {
  v.toggle("movie", output.movie, "<name>.mp4: true, false or how it is encoded");
  v.field("frames", output.frames, Spec{.meaning = "every frame as a PNG file"});
  v.field("stills", output.stills,
          Spec{.meaning = "frame times that are written as PNG files", .unit = "s", .range = not_negative});
  v.group("log", "log.csv", [&](auto& sub) {
    sub.field("every", output.log.every, Spec{.meaning = "time between rows", .unit = "s", .range = positive});
  });
  v.toggle("particles", output.particles,
           "particles_00000.vtp and so on, and particles.pvd, for ParaView: true, false or what they hold");
  v.not_built("checkpoint", EmptyForm::off, "checkpoints");
}

template <class V>
void describe(V& v, Scene& scene) {
  v.version("weir", format_version);
  v.field("name", FileName{scene.name},
          Spec{.meaning = "names the run folder and the movie: letters (a-z, A-Z), digits, _ - .; by default the scene "
                          "file's name"});
  v.field("title", scene.title, Spec{.meaning = "shown in the picture's corner"});
  v.field("dimension", scene.dimension,
          Spec{.meaning = "2 or 3; a vector has that many numbers", .range = {2, 3}, .required = true});
  v.field("duration", scene.duration, Spec{.meaning = "run time", .unit = "s", .range = positive, .required = true});
  v.field("gravity", scene.gravity,
          Spec{.meaning = "acceleration of everything; by default downwards, -y in 2D and -z in 3D", .unit = "m/s^2"});
  v.group("particles", "resolution", [&](auto& sub) {
    sub.field("spacing", scene.particle_spacing,
              Spec{.meaning = "distance dx of particles at rest", .unit = "m", .range = positive, .required = true});
  });
  v.group("fluid", "the fluid", [&](auto& sub) { describe(sub, scene.fluid); });
  v.list("walls", scene.walls, Spec{.meaning = "solid boundaries"});
  v.field("periodic", scene.periodic,
          Spec{.meaning = "axes along which particles that leave the domain at one end enter it at the other"});
  v.option("domain", scene.domain,
           "extent along periodic axes, a whole number of spacings; by default the span of fluid volumes and walls, "
           "without the walls' layers");
  v.not_built("bodies", EmptyForm::list, "rigid bodies");
  v.group("solver", "the method", [&](auto& sub) { describe(sub, scene.solver); });
  v.list("timeline", scene.timeline, Spec{.meaning = "changes during the run"});
  v.group("camera", "view of the pictures", [&](auto& sub) { describe(sub, scene.camera); });
  v.group("render", "appearance of the pictures", [&](auto& sub) { describe(sub, scene.render); });
  v.not_built("probes", EmptyForm::list, "probes");
  v.group("output", "files that are written", [&](auto& sub) { describe(sub, scene.output); });
}

}  // namespace weir
