#include "sim/config.h"

#include "models/model.h"
#include "transport/executor.h"

namespace erg {
namespace {

constexpr const char* default_model = "momiji";

Parameter only_when(Parameter parameter, std::vector<std::string> condition) {
  parameter.only_when = std::move(condition);
  return parameter;
}

}  // namespace

Parameters grid_parameters() {
  return {
      integer_parameter("nx", "Cells east", "cells", 256, smallest_side, largest_side, "Grid width, west to east."),
      integer_parameter("ny", "Cells north", "cells", 256, smallest_side, largest_side, "Grid height, south to north."),
      real_parameter("cell_size", "Cell size", "m", 1.0, 0.001, 1000.0, "Side of a cell."),
      choice_parameter("boundary", "Boundary", "torus", {"torus", "open"},
                       "torus: what leaves on one side enters on the other; open: it is counted and gone."),
      only_when(real_parameter("inflow", "Inflow", "slabs", 0.0, 0.0, 100.0,
                               "Slabs that enter per time step and cell of the upwind edge."),
                {"boundary", "open"}),
  };
}

Parameters scene_parameters() {
  return {
      choice_parameter(
          "kind", "Scene", "flat",
          {"flat", "random", "ripples", "transverse", "rocks", "uneven", "hump", "dune", "valley", "cone", "image"},
          "What lies on the grid before the first step."),
      real_parameter("sand", "Sand", "slabs", 3.0, 0.0, 10000.0, "Mean thickness of the mobile layer in slabs a cell."),
      only_when(real_parameter("height", "Height", "m", 4.0, 0.0, 10000.0,
                               "Height of the rocks, hump, dune or cone; from trough to crest of ripples, transverse "
                               "dunes, uneven ground and valley."),
                {"kind", "ripples", "transverse", "rocks", "uneven", "hump", "dune", "valley", "cone"}),
      only_when(real_parameter("wavelength", "Wavelength", "cells", 32.0, 2.0, largest_side,
                               "From crest to crest of ripples, transverse dunes and uneven ground; width of the "
                               "valley."),
                {"kind", "ripples", "transverse", "uneven", "valley"}),
      only_when(real_parameter("radius", "Radius", "cells", 32.0, 1.0, largest_side,
                               "From the middle to the foot of the hump, dune or cone."),
                {"kind", "hump", "dune", "cone"}),
      only_when(path_parameter("image", "Picture", "Grey picture (PNG) of the heights; relative to the config file."),
                {"kind", "image"}),
      only_when(choice_parameter("image_role", "Picture shows", "bedrock", {"bedrock", "sand", "both"},
                                 "What the picture's heights become: bedrock under an even cover of sand, the sand "
                                 "itself, or the surface of bedrock and sand together."),
                {"kind", "image"}),
      only_when(real_parameter("image_low", "Height of black", "m", 0.0, -10000.0, 10000.0,
                               "Height of a black point of the picture."),
                {"kind", "image"}),
      only_when(real_parameter("image_high", "Height of white", "m", 10.0, -10000.0, 10000.0,
                               "Height of a white point of the picture."),
                {"kind", "image"}),
  };
}

Parameters run_parameters() {
  constexpr std::int64_t most_steps = 1'000'000'000;
  constexpr std::int64_t largest_seed = std::int64_t{1} << 53;  // every JSON reader keeps whole numbers up to here
  return {
      integer_parameter("steps", "Steps", "", 1000, 0, most_steps, "Time steps to run."),
      integer_parameter("seed", "Seed", "", 0, 0, largest_seed, "The same seed gives the same dunes everywhere."),
      choice_parameter("executor", "Executor", "auto", executor_names(),
                       "serial: one slab at a time, the reference; cpu: parallel sub-sweeps; auto: the fastest that "
                       "works."),
      only_when(integer_parameter("threads", "Threads", "", 0, 0, 256,
                                  "Threads to use; 0: one for each processor. Results do not depend on it."),
                {"executor", "auto", "cpu"}),
      only_when(choice_parameter("sweeps", "Sub-sweeps", "16", {"2", "4", "8", "16", "32", "64"},
                                 "Sub-sweeps that a time step is split into: more are slower and closer to one slab "
                                 "at a time."),
                {"executor", "auto", "cpu"}),
  };
}

}  // namespace erg
