#include "models/slab/momiji.h"

#include "models/slab/slab_model.h"

namespace erg::models {

ModelType momiji() {
  return slab_model_type(
      {.key = "momiji",
       .title = "Momiji et al. 2000",
       .citation =
           "Momiji, H., Carretero-Gonzalez, R., Bishop, S. R. & Warren, A. (2000). Simulation of the effect of wind "
           "speedup in the formation of transverse dune fields. Earth Surface Processes and Landforms 25, 905-918.",
       .produces = "barchans and transverse dunes with a gentle stoss and a steep lee",
       .limitations = "air flow, grain sizes; the speed-up is a function of height alone",
       .start = {.spread = natural_spread}},
      {.repose_angle = 33.7, .lift_in_shadow = false, .hop_grows_with_height = true, .deviation_weight = 0});
}

}  // namespace erg::models
