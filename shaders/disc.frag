#version 450 core
// A disc with antialiased edge: how much of the pixel's square lies inside the circle.

flat in vec2 center;
flat in float disc_radius;
flat in vec4 color;

uniform bool shaded;  // as a ball, lit from above the viewer's left shoulder

layout(location = 0) out vec4 result;

// Gauss-Legendre nodes and weights for the mean over [-1/2, 1/2], three points.
const vec3 nodes = vec3(-0.3872983, 0.0, 0.3872983);
const vec3 weights = vec3(0.2777778, 0.4444444, 0.2777778);

// The chord of the circle is cut with the pixel's column exactly, and its length averaged over the pixel's width. Taken
// across the steeper side of the edge (`off` sorted), the chord is smooth; the error stays below 0.02.
float coverage(vec2 off) {
  off = abs(off);
  off = vec2(min(off.x, off.y), max(off.x, off.y));
  vec3 across = off.x + nodes;
  vec3 half_chord = sqrt(max(disc_radius * disc_radius - across * across, 0.0));
  vec3 inside = clamp(min(vec3(off.y + 0.5), half_chord) - max(vec3(off.y - 0.5), -half_chord), 0.0, 1.0);
  return dot(weights, inside);
}

void main() {
  vec2 off = gl_FragCoord.xy - center;
  vec3 rgb = color.rgb;
  if (shaded) {
    vec2 across = off / disc_radius;
    vec3 normal = vec3(across.x, -across.y, sqrt(max(1.0 - dot(across, across), 0.0)));
    rgb *= 0.45 + 0.55 * max(dot(normal, normalize(vec3(-0.4, 0.7, 0.6))), 0.0);
  }
  result = vec4(rgb, color.a * coverage(off));
}
