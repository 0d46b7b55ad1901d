#version 330 core
// One triangle that covers the target, behind all else: a fragment for each of its texels.
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
  gl_Position = vec4(corner, 1.0, 1.0);
}
