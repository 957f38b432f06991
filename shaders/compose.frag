#version 450 core
// Lays particles, of which the processor has made pixels, over the background. Each fragment is a block of 4 x 2 pixels:
// looking up costs as much as mixing, and a block holds whole samples of chroma.
//
// OVERLAY: with a layer on top. YUV: out comes Y'CbCr of a movie, otherwise RGBA.

uniform usamplerBuffer first_texels;      // of each square: where its texels begin
uniform usamplerBuffer particle_texels;   // as in texel.h: block by block the upper row, then the lower
uniform usamplerBuffer particle_pixels;   // the same, one by one
uniform usamplerBuffer under_texels;      // rows of the background, 4 pixels a texel, colours multiplied with alpha
uniform usamplerBuffer under_pixels;      // the same, one by one
uniform int square_columns;
uniform int under_columns;                // texels a row
uniform usampler2D over_even;             // even rows of the layer on top, colours not multiplied
uniform usampler2D over_odd;
uniform bool straight;                    // RGBA is not multiplied with alpha

// What is mixed: the background of a movie is opaque.
#ifdef YUV
#define Color vec3
#else
#define Color vec4
#endif

#ifdef YUV
// A sample of chroma lies beside the left edge of its 2 x 2 pixels and takes a quarter of the pixel to its left.
const int columns = 5;
layout(location = 0) out uint even_row;
layout(location = 1) out uint odd_row;
layout(location = 2) out uint blue_difference;
layout(location = 3) out uint red_difference;
#else
const int columns = 4;
layout(location = 0) out uvec4 even_row;
layout(location = 1) out uvec4 odd_row;
#endif
const int first_column = 4 - columns;
const int count = 2 * columns;

vec3 rgb_of(uint color) { return vec3(color & 255u, color >> 8 & 255u, color >> 16 & 255u); }
float alpha_of(uint color) { return float(color >> 24) / 255.0; }

// The pixels of a block, and those to its left.
void unpack_rows(uint left_even, uint left_odd, uvec4 even, uvec4 odd, out uint pixels[count]) {
#ifdef YUV
  pixels[0] = left_even;
  pixels[columns] = left_odd;
#endif
  for (int c = 0; c < 4; ++c) {
    pixels[c - first_column] = even[c];
    pixels[columns + c - first_column] = odd[c];
  }
}

void lay_over(inout Color colors[count], uint top[count]) {
#ifdef YUV
  for (int k = 0; k < count; ++k) colors[k] = mix(colors[k], rgb_of(top[k]), alpha_of(top[k]));
#else
  for (int k = 0; k < count; ++k) colors[k] = mix(colors[k], vec4(rgb_of(top[k]), 1.0), alpha_of(top[k]));
#endif
}

// Where a block's upper row stands among the texels of particles.
int place_of(ivec2 block) {
  const int side = 8;  // blocks a square
  ivec2 square = block / side;
  ivec2 within = block % side;
  uint first = texelFetch(first_texels, square.y * square_columns + square.x).x;
  return int(first) + 2 * (within.y * side + within.x);
}

uint pack(vec4 v) {
  uvec4 bytes = uvec4(v + 0.5);
  return bytes.x | bytes.y << 8 | bytes.z << 16 | bytes.w << 24;
}

#ifdef YUV
// [Rec. ITU-R BT.709-6, 3.2 to 3.5], 8 bits, from RGB of 0 .. 255
const vec3 luma = vec3(0.2126, 0.7152, 0.0722);
float luma_of(vec3 rgb) { return 16.0 + 219.0 / 255.0 * dot(luma, rgb); }
vec2 chroma_of(vec3 rgb) {
  float y = dot(luma, rgb);
  return 128.0 + 224.0 / 255.0 * vec2(rgb.b - y, rgb.r - y) / vec2(1.8556, 1.5748);
}
#endif

void main() {
  ivec2 block = ivec2(gl_FragCoord.xy);
  ivec2 beside = ivec2(max(block.x - 1, 0), block.y);
  uint pixels[count];

  int even_at = 2 * block.y * under_columns + block.x;
  int odd_at = even_at + under_columns;
  int left_at = even_at + beside.x - block.x;
  unpack_rows(texelFetch(under_pixels, 4 * left_at + 3).x, texelFetch(under_pixels, 4 * (left_at + under_columns) + 3).x,
              texelFetch(under_texels, even_at), texelFetch(under_texels, odd_at), pixels);
  Color colors[count];
#ifdef YUV
  for (int k = 0; k < count; ++k) colors[k] = rgb_of(pixels[k]);
#else
  for (int k = 0; k < count; ++k) colors[k] = vec4(rgb_of(pixels[k]), alpha_of(pixels[k]));
#endif

  int at = place_of(block);
  left_at = place_of(beside);
  unpack_rows(texelFetch(particle_pixels, 4 * left_at + 3).x, texelFetch(particle_pixels, 4 * left_at + 7).x,
              texelFetch(particle_texels, at), texelFetch(particle_texels, at + 1), pixels);
  lay_over(colors, pixels);

#ifdef OVERLAY
  unpack_rows(texelFetch(over_even, beside, 0).w, texelFetch(over_odd, beside, 0).w, texelFetch(over_even, block, 0),
              texelFetch(over_odd, block, 0), pixels);
  lay_over(colors, pixels);
#endif

#ifdef YUV
  if (block.x == 0) {  // the picture goes on as it begins
    colors[0] = colors[1];
    colors[columns] = colors[columns + 1];
  }
  vec3 both[columns];
  for (int c = 0; c < columns; ++c) both[c] = colors[c] + colors[columns + c];
  even_row = pack(vec4(luma_of(colors[1]), luma_of(colors[2]), luma_of(colors[3]), luma_of(colors[4])));
  odd_row = pack(vec4(luma_of(colors[6]), luma_of(colors[7]), luma_of(colors[8]), luma_of(colors[9])));
  vec2 first = chroma_of((both[0] + 2.0 * both[1] + both[2]) / 8.0);
  vec2 last = chroma_of((both[2] + 2.0 * both[3] + both[4]) / 8.0);
  blue_difference = uint(first.x + 0.5) | uint(last.x + 0.5) << 8;
  red_difference = uint(first.y + 0.5) | uint(last.y + 0.5) << 8;
#else
  for (int k = 0; k < count; ++k) {
    float scale = straight && colors[k].a > 0.0 ? 1.0 / colors[k].a : 1.0;
    colors[k] = vec4(min(colors[k].rgb * scale, 255.0), 255.0 * colors[k].a);
  }
  even_row = uvec4(pack(colors[0]), pack(colors[1]), pack(colors[2]), pack(colors[3]));
  odd_row = uvec4(pack(colors[4]), pack(colors[5]), pack(colors[6]), pack(colors[7]));
#endif
}
