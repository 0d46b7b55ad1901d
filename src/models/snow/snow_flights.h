// The flights of a step of sintering snow, on all threads: K sub-sweeps over strips of lines.
//
// Each sub-sweep polls a random 1/K of the cells and follows the lines down the wind once: slabs lift, come down, free
// bonded snow, stay or fly on. What flies over the torus edge goes on in the next sub-sweep, or, where an oblique line
// goes on as another one there, after the last; then passes without polls bring all of it down. So nothing in one line
// waits for another, and a strip stays in a processor's cache for all its sub-sweeps.
#pragma once

#include <functional>

#include "compute/executor.h"
#include "models/snow/snow_draws.h"
#include "models/snow/snow_strip.h"
#include "models/step_report.h"

namespace erg {

class SnowFlights {
 public:
  /// Moves the snow in the plan's layers. The same bits for any number of threads and any instruction set.
  StepReport fly(SnowFlightPlan plan, InstructionSet instructions, Executor& executor);

 private:
  bool lines_close() const { return draws_.lines_close(plan_.frame, plan_.boundary); }
  const SnowSweep& sweep_number(std::size_t number) const { return draws_.sweeps[draws_.sweep_number(number)]; }
  void find_upwind();
  void find_walls(Executor& executor);
  void for_strips(Executor& executor, const std::function<void(SnowStrip& strip, int first)>& work);
  void begin(SnowStrip& strip, int first) const;
  void fly_strip(SnowStrip& strip, int first);
  void bring_down(Executor& executor);
  bool hand_over();

  SnowFlightPlan plan_;
  SnowDraws draws_;
  SnowPlaces places_;
  std::vector<std::int32_t> upwind_;
  std::vector<SnowStrip> strips_;  ///< one for each thread, which does one strip after another in its memory
  std::vector<std::vector<SnowStrip::Carried>> handed_over_;  ///< to each strip
};

}  // namespace erg
