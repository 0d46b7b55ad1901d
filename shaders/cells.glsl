// Reading cells of the grid by their column and row.
uniform sampler2D cells;  // surface and thickness of the mobile layer, m
uniform ivec2 extent;     // columns and rows
uniform bool periodic;    // a torus; otherwise the outermost cells go on

vec2 cell(ivec2 place) {
  place = periodic ? place - extent * ivec2(floor(vec2(place) / vec2(extent))) : clamp(place, ivec2(0), extent - 1);
  return texelFetch(cells, place, 0).rg;
}
