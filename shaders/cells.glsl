// Reading cells of the grid by their column and row.
uniform sampler2D cells;  // surface and thickness of the mobile layer, m
uniform ivec2 extent;     // columns and rows
uniform bool periodic;    // a torus; otherwise the outermost cells go on

// A place up to one grid over the edges, brought inside.
ivec2 inside(ivec2 place) {
  if (!periodic) return clamp(place, ivec2(0), extent - 1);
  return ivec2(mod(vec2(place) + 0.5, vec2(extent)));
}
vec4 cell4(ivec2 place) { return texelFetch(cells, inside(place), 0); }
vec2 cell(ivec2 place) { return cell4(place).rg; }
