// Time steps of drifting, bonding snow on the processor's threads: finds the snow in the terrain's fields, has the
// machine carry out the step, and shows the strength of what it leaves.
#pragma once

#include <cstdint>

#include "models/snow/snow_machine.h"
#include "models/snow/snow_step.h"

namespace erg {

class SnowDrift {
 public:
  explicit SnowDrift(InstructionSet instructions = wanted_instruction_set())
      : instructions_(instructions), machine_(instructions) {}

  /// One step on the threads of `executor`, in as many sub-sweeps as it has. The terrain must be settled and have the
  /// fields of SnowLayer; it is up to date afterwards. Throws InputError if the snow has grown too high to be counted.
  StepReport step(Terrain& terrain, const SnowStep& snow, const WindNow& wind, StepKey key, Executor& executor);

 private:
  bool holds(const Terrain& terrain) const;
  void load(const Terrain& terrain);
  void write_strength(const SnowLaw& law, const Terrain& terrain, Grid<float>& strength, Executor& executor) const;

  InstructionSet instructions_;
  SnowMachine machine_;
  SnowLayers layers_;
  std::uint64_t stamp_ = 0;  ///< of the terrain whose loose snow `layers_` counts
  std::uint64_t fields_stamp_ = 0;
};

}  // namespace erg
