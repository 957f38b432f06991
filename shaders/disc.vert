#version 450 core
// One particle becomes a disc on the picture: its centre and radius in pixels, and its colour.
// POINTS: a point sprite a particle. Otherwise a quad of four vertices for each instance, for discs beyond the point
// size that the driver allows.

layout(location = 0) in vec4 particle;  // x, y, z in m; w = the quantity shown

uniform vec3 eye;      // m; see projection.h
uniform vec3 right;
uniform vec3 up;
uniform vec3 forward;
uniform bool perspective;
uniform float focal;     // pixels per metre, in perspective at one metre of depth
uniform vec2 principal;  // pixels
uniform float radius;    // m
uniform vec2 viewport;   // pixels: the picture and the border around it
uniform float border;    // pixels
uniform vec2 range;      // of the quantity: the ends of the colour map
layout(std140, binding = 0) uniform Colormap { vec4 colors[256]; };  // linear steps of the map, sRGB

flat out vec2 center;       // pixels, from the picture's top left corner
flat out float disc_radius; // pixels
flat out vec4 color;

// Below this radius, in pixels, a disc keeps this size and becomes fainter instead, with the same area: the edge of a
// smaller one turns too sharply within a pixel for the fragment shader's three chords.
const float least_radius = 1.0;

// Pixels whose centre is half a pixel beyond the disc, across or down, do not touch it; and a little for the rounding of
// positions to 1/256 pixel.
const float rim = 0.51;

void main() {
  vec3 seen = particle.xyz - eye;
  float depth = perspective ? dot(forward, seen) : 1.0;
  float scale = perspective ? focal / depth : focal;
  center = principal + scale * vec2(dot(right, seen), -dot(up, seen));
  float true_radius = scale * radius;
  disc_radius = max(true_radius, least_radius);
  float share = true_radius / disc_radius;

  float along = (particle.w - range.x) / (range.y - range.x);
  color = colors[int(floor(clamp(along, 0.0, 1.0) * 255.0 + 0.5))];
  color.a *= share * share;

  float half_size = disc_radius + rim;
  vec2 position = center;
#ifdef POINTS
  gl_PointSize = 2.0 * half_size;
#else
  position += half_size * vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
#endif
  // The framebuffer's first row is the picture's top row, so that it is read back the right way round.
  gl_Position = vec4((position + border) / viewport * 2.0 - 1.0, 0.0, 1.0);
  // Behind the eye, or nearer to it than its own radius: not drawn.
  if (!(depth > radius) && perspective) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
