// Snow that bonds where it rests, and then erodes otherwise than it drifts.
//
// Physics: loose slabs on bonded ones. Loose snow lifts above a wind that grows with its age (Li & Pomeroy 1997) at the
// rate of the saltation flux, so that a step is real time; it hops, and rests more readily on loose snow than on hard.
// It bonds at a rate that follows the temperature. Slabs that strike bonded snow free some of it, the more the stronger
// the wind, the steeper the face and the weaker the snow. The idea that sintering makes the difference between dunes
// and sastrugi is Filhol & Sturm 2015; the formulation is our own, and what is fitted is said with each parameter.
// Does not model: melting, the air flow (speed-up is a function of smoothed heights), grains, suspension clouds.
#pragma once

namespace erg::models {

struct ModelType;

/// The catalogue entry.
ModelType snow_sintering();

}  // namespace erg::models
