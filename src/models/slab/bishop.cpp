#include "models/slab/bishop.h"

#include "models/slab/slab_model.h"

namespace erg::models {

ModelType bishop() {
  return slab_model_type(
      {.key = "bishop",
       .title = "Bishop et al. 2002",
       .citation = "Bishop, S. R., Momiji, H., Carretero-Gonzalez, R. & Warren, A. (2002). Modelling desert dune "
                   "fields based on discrete dynamics. Discrete Dynamics in Nature and Society 7, 7-17.",
       .produces = "barchans and transverse dunes with a gentle stoss, also where sand is sparse",
       .limitations = "air flow, grain sizes; the speed-up is a function of height alone",
       .start = {.spread = natural_spread}},
      {.repose_angle = 33.7, .lift_in_shadow = false, .hop_grows_with_height = true, .deviation_weight = 0.5});
}

}  // namespace erg::models
