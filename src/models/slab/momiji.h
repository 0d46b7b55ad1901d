// Momiji, Carretero-Gonzalez, Bishop & Warren 2000: Werner's slabs with wind that speeds up over dunes.
//
// Physics: as Werner 1995, but nothing lifts in the wind shadow, and a hop grows with the height above the mean
// surface: L = L0 + C1 (h - mean) + C2 (h - mean)^2 (the square only above the mean). So crests move faster than feet,
// and stoss slopes become gentle while lee slopes stand at repose. Does not model: the air flow itself; recirculation
// behind a crest is the 15 degree shadow.
#pragma once

namespace erg::models {

struct ModelType;

/// The catalogue entry.
ModelType momiji();

}  // namespace erg::models
