// What the mobile layer of a terrain is.
#pragma once

namespace erg {

enum class Material { sand, snow };

}  // namespace erg
