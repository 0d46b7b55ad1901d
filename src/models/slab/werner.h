// Werner 1995: slabs of sand on a grid of columns.
//
// Physics: each poll lifts one slab from a cell; it hops L cells downwind at a time and stays where it lands with
// chance p_sand or p_bare, and always in the 15 degree wind shadow of higher ground. Slopes above the angle of repose
// slide. Barchans, transverse, linear and star dunes follow from the wind alone. Assumes: one grain size, no moisture,
// wind that the dunes do not change. Does not model: speed-up of the wind over a dune (so stoss and lee are alike),
// grain by grain saltation, time in seconds.
#pragma once

namespace erg::models {

struct ModelType;

/// The catalogue entry.
ModelType werner();

}  // namespace erg::models
