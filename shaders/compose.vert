#version 450 core
// A square of blocks of the target, for each in a list: a point of that size, or, of OVERLAY, all of the target as a strip
// of two triangles. Points, because the software renderer shades the pixels along a triangle's edge for both sides.

uniform usamplerBuffer squares;  // column below 16 bits of row
uniform ivec2 blocks;            // the viewport's size
uniform int square_size;         // blocks

void main() {
#ifdef OVERLAY
  gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0, 0.0, 1.0);
#else
  uint square = texelFetch(squares, gl_VertexID).x;
  vec2 middle = (vec2(square & 0xffffu, square >> 16) + 0.5) * float(square_size);
  gl_Position = vec4(middle / vec2(blocks) * 2.0 - 1.0, 0.0, 1.0);
  gl_PointSize = float(square_size);
#endif
}
