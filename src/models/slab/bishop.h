// Bishop, Momiji, Carretero-Gonzalez & Warren 2002: Momiji's model with a reference height that follows the relief.
//
// Physics: as Momiji et al. 2000, with the mean height replaced by h_ref = mean - (1 / 2N) * sum |h - mean| (their
// effective flat surface; Cimbura 2022, eq. 4.2), so that sparse dunes speed the wind up as strongly as dense ones. The
// publication turned the grid to turn the wind, and up to 10 % of the sand was lost or gained; here the wind turns and
// every slab is accounted for.
#pragma once

namespace erg::models {

struct ModelType;

/// The catalogue entry.
ModelType bishop();

}  // namespace erg::models
