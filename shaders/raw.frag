#version 330 core
// The cells as they are.
#include "cells.glsl"
out vec2 surface;
void main() { surface = cell(ivec2(gl_FragCoord.xy)); }
