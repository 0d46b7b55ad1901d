// Executors: what carries out a model's time step, and shares out its other work over threads. `serial` is the
// reference (one slab at a time), `cpu` the parallel engine, `cuda` the same on a graphics card. A model hands over a
// law, of slabs (slab_law.h), of single grains (grain_step.h) or of bonding snow (snow_step.h), and never moves them
// itself.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/random.h"
#include "core/terrain.h"
#include "forcing/regime.h"
#include "transport/slab_law.h"
#include "transport/step_report.h"

namespace erg {

struct FrozenGround;
struct GrainReport;
struct GrainStepLaw;
struct SnowStep;
/// Called with the ground that the flights of a step's last sub-step see; it may fly some of them once more.
using GroundLook = std::function<void(const FrozenGround& ground)>;

/// Carries out time steps.
///
/// An executor may keep the terrain in a form of its own between steps. Then the terrain's layers are stale until
/// `settle` writes them back; whoever owns both calls it before anyone reads. Editing the terrain (its stamp
/// changes) makes the executor load it again at the next step.
class Executor {
 public:
  virtual ~Executor() = default;

  /// What does the work now: "serial", "cpu", "cuda".
  virtual std::string name() const = 0;
  /// Threads of the processor that it works on.
  virtual int threads() const = 0;
  /// Sub-sweeps that a step is cut into; 0: one slab at a time.
  virtual int sub_sweeps() const { return 0; }
  /// Moves the slabs of one time step and books in- and outflow in the terrain's ledger; a wind of strength 0 is a
  /// calm, in which nothing moves. Where this or another kind of step throws in the middle, the executor holds nothing
  /// any more, and the terrain is no moment of the run: its owner goes back to one that was.
  StepReport step(Terrain& terrain, const SlabLaw& law, const WindNow& wind, StepKey key) {
    return wind.strength > 0 ? move_slabs(terrain, law, wind, key) : StepReport{};
  }
  /// Flies the grains of one time step, lets their bed slide, creep and bond, and books in- and outflow. The same bits
  /// on every executor. `look` may be empty.
  virtual GrainReport fly_grains(Terrain& terrain, const GrainStepLaw& law, const WindNow& wind, StepKey key,
                                 const GroundLook& look) = 0;
  /// Lets snow drift, slide, fall and bond for one time step, and books in- and outflow. The terrain has the fields of
  /// SnowLayer. Throws InputError if the snow has grown too high to be counted.
  virtual StepReport drift_snow(Terrain& terrain, const SnowStep& snow, const WindNow& wind, StepKey key) = 0;
  /// Brings the terrain's layers up to date, and its fields where an executor changes them.
  virtual void settle(Terrain& terrain) = 0;
  /// Adds, from the next step on, the slabs that the polls of a step lift from each cell to `counts`, whose extent is
  /// the terrain's and which must stay; null: no longer. Costs some time, and changes nothing else. In all cells
  /// together a step adds its `lifts`.
  void count_lifts(Grid<std::int32_t>* counts) { lift_counts_ = counts; }
  /// Where lifts are counted; null: nowhere.
  Grid<std::int32_t>* lift_counts() const { return lift_counts_; }
  /// What the user should know that happened since this was last asked (a device was lost), in one line; mostly empty.
  virtual std::string take_notice() { return {}; }
  /// Runs `work` over pieces [begin, end) that together are [0, items), on all threads, and returns when all are done:
  /// for what a model does between the slabs' moves. Pieces must not depend on each other, nor the result on where
  /// they begin. What `work` throws for a piece is thrown here once all threads are done; other pieces may be missing.
  virtual void for_pieces(std::int64_t items,
                          const std::function<void(std::int64_t begin, std::int64_t end)>& work) = 0;

 protected:
  /// `step` in a wind of more than no strength.
  virtual StepReport move_slabs(Terrain& terrain, const SlabLaw& law, const WindNow& wind, StepKey key) = 0;

 private:
  Grid<std::int32_t>* lift_counts_ = nullptr;
};

/// The variable of the environment that forces an InstructionSet.
inline constexpr const char* instructions_variable = "ERG_INSTRUCTIONS";

/// Which machine instructions the parallel engine may use. All give the same bits.
enum class InstructionSet { portable, avx2, avx512 };
/// The best that this processor has.
InstructionSet best_instruction_set();
/// "portable", "avx2", "avx512".
std::string to_string(InstructionSet set);
/// The set of this name. Throws InputError, at `place`, for an unknown name and for a set that this processor lacks.
InstructionSet find_instruction_set(const std::string& name, const std::string& place);
/// The set that the variable ERG_INSTRUCTIONS of the environment asks for, for tests and reports; the best one where it
/// asks for none. Throws InputError as find_instruction_set.
InstructionSet wanted_instruction_set();

/// Which executor, and how it works.
struct ExecutorOptions {
  std::string name = "auto";  ///< one of executor_names(); "auto" takes the fastest that works
  int threads = 0;            ///< 0: one for each processor
  int sweeps = 16;            ///< K, sub-sweeps a step (cpu, cuda): a power of two, 2 to 64
  InstructionSet instructions = wanted_instruction_set();
  /// Lines along the wind that are worth a thread of their own in sub-sweeps: with fewer, what a row costs however
  /// short it is outweighs the help. The same bits with any number.
  int lines_a_thread = 256;

  bool operator==(const ExecutorOptions&) const = default;
};

/// "auto", "serial", "cpu", "cuda". This and make_executor stand in the layer `executors`, which knows them all.
const std::vector<std::string>& executor_names();

/// The highest cell over the lowest bedrock that executors count, in slabs: 16 bits, with room for what a step may add.
inline constexpr int highest_terrain = 40000;
/// What executors need to know of a terrain before they load it.
struct TerrainHeights {
  std::int32_t lowest = 0;   ///< bedrock
  std::int32_t highest = 0;  ///< surface, over the lowest bedrock
  bool relief = false;       ///< the bedrock is not level
  std::int64_t bedrock_total = 0;
  std::int64_t mobile_total = 0;
};
/// Throws InputError if the highest cell stands more than `highest_terrain` over the lowest bedrock.
TerrainHeights check_height(const Terrain& terrain);

/// Throws InputError for an unknown name. "cuda" where no device works is the processor with a notice; "auto" then is
/// the processor without one.
std::unique_ptr<Executor> make_executor(const ExecutorOptions& options);

}  // namespace erg
