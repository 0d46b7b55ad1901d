#include "models/slab/werner.h"

#include "models/slab/slab_model.h"

namespace erg::models {

ModelType werner() {
  return slab_model_type({.key = "werner",
                          .title = "Werner 1995",
                          .citation = "Werner, B. T. (1995). Eolian dunes: computer simulations and attractor "
                                      "interpretation. Geology 23, 1107-1110.",
                          .produces = "barchans, transverse, linear and star dunes, symmetric in profile",
                          .limitations = "wind speed-up over dunes, air flow, grain sizes",
                          .start = {.spread = natural_spread}},
                         {});
}

}  // namespace erg::models
