// Werner's dunes in a land of showers: where rain has fallen, wet sand holds together until it has dried.
//
// Physics: now and then a shower wets a disc of ground; wet grains cohere, so none lift and what blows there stays
// (Wiggs, Baird & Atherton 2004 measured how quickly a surface dries and sand moves again). Does not model: how deep
// the rain soaks in, run-off, the sun, salt.
#pragma once

#include "models/model.h"

namespace erg {

/// The catalogue entry.
models::ModelType showers();

}  // namespace erg
