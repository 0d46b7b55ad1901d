// The sheet of the terrain that is drawn: the maps lie over it with an apron of what is around.
uniform vec2 terrain;       // m: extent of the whole terrain, east and north
uniform vec2 sheet_low;  // m: the south-west corner of the maps
uniform vec2 sheet_size; // m: their extent
uniform float cell_side; // m: of what is drawn as one cell
uniform float exaggeration;
uniform bool raw_cells;  // no smoothing: straight lines from cell to cell

// A place of the terrain as a place of the maps.
vec2 on_maps(vec2 metres) { return (metres - sheet_low) / sheet_size; }
