#version 330 core
// Paths of grains through the air.
layout(location = 0) in vec3 place;  // m
uniform float exaggeration;
uniform float lift;  // m above the place, so that lines on the ground are not hidden in it
uniform mat4 view_projection;
void main() { gl_Position = view_projection * vec4(place.xy, place.z * exaggeration + lift, 1.0); }
