#version 450 core
// A square of blocks of the target, for each in a list.

uniform usamplerBuffer squares;  // column below 16 bits of row
uniform ivec2 blocks;            // the target's size
uniform int square_size;         // blocks

void main() {
  uint square = texelFetch(squares, gl_InstanceID).x;
  ivec2 corner = ivec2(square & 0xffffu, square >> 16) + ivec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = vec4(vec2(corner * square_size) / vec2(blocks) * 2.0 - 1.0, 0.0, 1.0);
}
