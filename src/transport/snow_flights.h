// The flights of a step of sintering snow, on all threads: K sub-sweeps over strips of lines.
//
// Each sub-sweep polls a random 1/K of the cells and follows the lines down the wind once: slabs lift, come down, free
// bonded snow, stay or fly on. What flies over the torus edge goes on in the next sub-sweep; after the last one further
// passes without polls bring all of it down. Lines stay what they are for the step, and nothing in one line waits for
// another, except that an oblique line goes on as another one behind the torus edge.
#pragma once

#include "transport/snow_strip.h"

namespace erg {

class SnowFlights {
 public:
  /// Moves the snow in the plan's layers. The same bits for any number of threads and any instruction set.
  StepReport fly(SnowFlightPlan plan, InstructionSet instructions, Executor& executor);

 private:
  void draw_lines();
  void draw_sweeps();
  void fly_strip(SnowStrip& strip);
  void fly_together(Executor& executor);
  bool hand_over();

  SnowFlightPlan plan_;
  std::vector<int> offsets_;
  std::vector<SnowSweep> sweeps_;  ///< and the passes without polls that may follow
  std::vector<SnowStrip> strips_;
};

}  // namespace erg
