#version 450 core
// Each fragment shades a block of 4 x 2 pixels: it looks up the discs that touch it in the bins and mixes them over the
// background. Blocks, because looking up costs as much as shading; 4 x 2, because a block holds whole samples of chroma.
//
// PIXELS: dots or balls, of which the processor has made pixels, instead of discs. OVERLAY: a layer on top. YUV: out comes
// Y'CbCr of a movie, otherwise RGBA.
//
// Pixels do not depend on the order in which particles came: what decides overlaps of discs are minima.

uniform usamplerBuffer bins;      // for each the first entry and the one past the last; past before first: nothing to do
uniform usamplerBuffer entries;   // discs as in disc_painter.cpp, or PIXELS as in texel.h
uniform usamplerBuffer under;     // rows of the background, 4 pixels a texel, colours multiplied with alpha
uniform int under_columns;        // texels a row
uniform usampler2D over_even;     // even rows of the layer on top, colours not multiplied
uniform usampler2D over_odd;
uniform int bin_shift;            // a bin is 2^bin_shift blocks wide and high
uniform int bin_columns;
uniform float radius;             // pixels
uniform float edge;               // of discs, pixels; see coverage()
uniform float opacity;            // of all discs
uniform vec3 background;          // 0 .. 255, behind all that is translucent in a movie
uniform bool straight;            // RGBA is not multiplied with alpha

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
const float far = 1e38;  // squared pixels

vec3 unpack_rgb(uint color) { return vec3(color & 255u, color >> 8 & 255u, color >> 16 & 255u); }

// How much of a pixel a disc covers, from the squared distance of its centre alone: a smooth step of 4/3 pixels, in the
// middle between edges along the pixels and across. It is off by 0.043 at most, where a straight edge along the pixels
// just touches one: that gets a step of 7/8 in place of 1. `edge` is such that the integral is the disc's area.
float coverage(float squared) {
  float along = clamp(0.5 + 0.75 * (edge - sqrt(squared)), 0.0, 1.0);
  return along * along * (3.0 - 2.0 * along);
}

uvec2 bin_of(ivec2 block) {
  ivec2 bin = block >> bin_shift;
  return texelFetch(bins, bin.y * bin_columns + bin.x).xy;
}

#ifdef PIXELS
// The upper and the lower row of a block.
void fetch_pixels(ivec2 block, out uvec4 even, out uvec4 odd) {
  uvec2 range = bin_of(block);
  ivec2 within = block & (1 << bin_shift) - 1;
  int at = int(range.x) + 2 * ((within.y << bin_shift) + within.x);
  bool filled = range.x < range.y;
  even = filled ? texelFetch(entries, at) : uvec4(0u);
  odd = filled ? texelFetch(entries, at + 1) : uvec4(0u);
}
#endif

// The pixels of a block, as the textures of the background hold them; `left` is the block to its left.
void unpack_rows(uvec4 left_even, uvec4 left_odd, uvec4 even, uvec4 odd, out vec4 pixels[count]) {
  uint texels[count];
#ifdef YUV
  texels[0] = left_even.w;
  texels[columns] = left_odd.w;
#endif
  for (int c = 0; c < 4; ++c) {
    texels[c - first_column] = even[c];
    texels[columns + c - first_column] = odd[c];
  }
  for (int k = 0; k < count; ++k) pixels[k] = vec4(unpack_rgb(texels[k]), float(texels[k] >> 24) / 255.0);
}

void lay_over(inout vec4 pixels[count], vec4 top[count]) {
  for (int k = 0; k < count; ++k) pixels[k] = mix(pixels[k], vec4(top[k].rgb, 1.0), top[k].a);
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
  uvec2 range = bin_of(block);
#ifndef OVERLAY  // which may have changed
  if (range.x > range.y) discard;
#endif

#ifndef PIXELS
  float x[columns];
  for (int c = 0; c < columns; ++c) x[c] = float(max(4 * block.x + c + first_column, 0)) + 0.5;
  float y[2] = float[2](float(2 * block.y) + 0.5, float(2 * block.y) + 1.5);

  // Of the two discs with the nearest centres, which cover all of a pixel that discs cover: the squared distance, whose
  // lowest 8 bits are the disc's place in the colour map, so that among equals the colour decides; and the colour.
  float nearest[count];
  float second[count];
  uint nearest_disc[count];
  uint second_disc[count];
  for (int k = 0; k < count; ++k) {
    nearest[k] = second[k] = far;
    nearest_disc[k] = second_disc[k] = 0u;
  }

  for (uint n = range.x; n < range.y; ++n) {
    uvec4 entry = texelFetch(entries, int(n));
    float center_x = uintBitsToFloat(entry.x);
    float center_y = uintBitsToFloat(entry.y);
    float squared_x[columns];
    for (int c = 0; c < columns; ++c) squared_x[c] = (x[c] - center_x) * (x[c] - center_x);
    uint color = entry.z;
    uint place = color >> 24;
    for (int r = 0; r < 2; ++r) {
      float squared_y = (y[r] - center_y) * (y[r] - center_y);
      for (int c = 0; c < columns; ++c) {
        int k = columns * r + c;
        float key = uintBitsToFloat((floatBitsToUint(squared_x[c] + squared_y) & ~255u) | place);
        second_disc[k] = key < nearest[k] ? nearest_disc[k] : key < second[k] ? color : second_disc[k];
        nearest_disc[k] = key < nearest[k] ? color : nearest_disc[k];
        second[k] = min(second[k], max(nearest[k], key));
        nearest[k] = min(nearest[k], key);
      }
    }
  }
#endif

  ivec2 beside = ivec2(max(block.x - 1, 0), block.y);
  vec4 pixels[count];
  int even_at = 2 * block.y * under_columns + block.x;
  int odd_at = even_at + under_columns;
  int left = beside.x - block.x;
  unpack_rows(texelFetch(under, even_at + left), texelFetch(under, odd_at + left), texelFetch(under, even_at),
              texelFetch(under, odd_at), pixels);
#if defined PIXELS || defined OVERLAY
  vec4 top[count];
#endif
#ifdef PIXELS
  uvec4 left_even, left_odd, even, odd;
  fetch_pixels(beside, left_even, left_odd);
  fetch_pixels(block, even, odd);
  unpack_rows(left_even, left_odd, even, odd, top);
  lay_over(pixels, top);
#else
  for (int k = 0; k < count; ++k) {
    float by_one = coverage(nearest[k]);
    float by_two = coverage(second[k]);
    float alpha = min(by_one + by_two, 1.0);
    // How much of the pixel lies on the nearest disc's side of the line between the two, were they tangent.
    float apart = by_two > 0.0 ? second[k] - nearest[k] : far;
    float side = clamp(0.5 + apart / (4.0 * radius), 0.5, 1.0);
    vec3 rgb = mix(unpack_rgb(second_disc[k]), unpack_rgb(nearest_disc[k]), side);
    pixels[k] = mix(pixels[k], vec4(rgb, 1.0), opacity * alpha);
  }
#endif

#ifdef OVERLAY
  unpack_rows(texelFetch(over_even, beside, 0), texelFetch(over_odd, beside, 0), texelFetch(over_even, block, 0),
              texelFetch(over_odd, block, 0), top);
  lay_over(pixels, top);
#endif

#ifdef YUV
  if (block.x == 0) {  // the picture goes on as it begins
    pixels[0] = pixels[1];
    pixels[columns] = pixels[columns + 1];
  }
  vec3 rgb[count];
  for (int k = 0; k < count; ++k) rgb[k] = pixels[k].rgb + (1.0 - pixels[k].a) * background;
  vec3 both[columns];
  for (int c = 0; c < columns; ++c) both[c] = rgb[c] + rgb[columns + c];
  even_row = pack(vec4(luma_of(rgb[1]), luma_of(rgb[2]), luma_of(rgb[3]), luma_of(rgb[4])));
  odd_row = pack(vec4(luma_of(rgb[6]), luma_of(rgb[7]), luma_of(rgb[8]), luma_of(rgb[9])));
  vec2 first = chroma_of((both[0] + 2.0 * both[1] + both[2]) / 8.0);
  vec2 last = chroma_of((both[2] + 2.0 * both[3] + both[4]) / 8.0);
  blue_difference = uint(first.x + 0.5) | uint(last.x + 0.5) << 8;
  red_difference = uint(first.y + 0.5) | uint(last.y + 0.5) << 8;
#else
  for (int k = 0; k < count; ++k) {
    float scale = straight && pixels[k].a > 0.0 ? 1.0 / pixels[k].a : 1.0;
    pixels[k] = vec4(min(pixels[k].rgb * scale, 255.0), 255.0 * pixels[k].a);
  }
  even_row = uvec4(pack(pixels[0]), pack(pixels[1]), pack(pixels[2]), pack(pixels[3]));
  odd_row = uvec4(pack(pixels[4]), pack(pixels[5]), pack(pixels[6]), pack(pixels[7]));
#endif
}
