// Executors: what carries out a time step of the slab machine, and shares out a model's other work over threads.
// `serial` is the reference (one slab at a time), `cpu` the parallel engine. A slab model hands over a law and never
// moves slabs itself.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/random.h"
#include "core/terrain.h"
#include "transport/slab_law.h"
#include "wind/regime.h"

namespace erg {

/// What one time step did, in counts.
struct StepReport {
  std::int64_t polls = 0;      ///< cells that were asked for a slab
  std::int64_t lifts = 0;      ///< slabs lifted
  double travel = 0;           ///< cells travelled downwind, summed over all slabs
  std::int64_t slabs_in = 0;   ///< entered over an open edge
  std::int64_t slabs_out = 0;  ///< left over an open edge
  bool finished = false;       ///< nothing can move any more
  std::string why_finished;

  StepReport& operator+=(const StepReport& other);
};

/// Carries out time steps.
///
/// An executor may keep the terrain in a form of its own between steps. Then the terrain's layers are stale until
/// `settle` writes them back; whoever owns both calls it before anyone reads. Editing the terrain (its revision
/// changes) makes the executor load it again at the next step.
class Executor {
 public:
  virtual ~Executor() = default;

  virtual std::string name() const = 0;
  virtual int threads() const = 0;
  /// Sub-sweeps that a step is cut into; 0: one slab at a time.
  virtual int sub_sweeps() const { return 0; }
  /// Moves the slabs of one time step and books in- and outflow in the terrain's ledger.
  virtual StepReport step(Terrain& terrain, const SlabLaw& law, const WindNow& wind, StepKey key) = 0;
  /// Brings the terrain's layers up to date.
  virtual void settle(Terrain& terrain) = 0;
  /// Adds, from the next step on, the slabs that the polls of a step lift from each cell to `counts`, whose extent is
  /// the terrain's and which must stay; null: no longer. Costs some time, and changes nothing else. In all cells
  /// together a step adds its `lifts`.
  void count_lifts(Grid<std::int32_t>* counts) { lift_counts_ = counts; }
  /// Where lifts are counted; null: nowhere. A model that lifts slabs itself adds them here.
  Grid<std::int32_t>* lift_counts() const { return lift_counts_; }
  /// What the user should know that happened since this was last asked (a device was lost), in one line; mostly empty.
  virtual std::string take_notice() { return {}; }
  /// Runs `work` over pieces [begin, end) that together are [0, items), on all threads, and returns when all are done:
  /// for what a model does between the slabs' moves. Pieces must not depend on each other, nor the result on where
  /// they begin; `work` must not throw.
  virtual void for_pieces(std::int64_t items,
                          const std::function<void(std::int64_t begin, std::int64_t end)>& work) = 0;

 private:
  Grid<std::int32_t>* lift_counts_ = nullptr;
};

/// Which machine instructions the parallel engine may use. All give the same bits.
enum class InstructionSet { portable, avx2, avx512 };
/// The best that this processor has.
InstructionSet best_instruction_set();
std::string to_string(InstructionSet set);

struct ExecutorOptions {
  std::string name = "auto";  ///< one of executor_names(); "auto" takes the fastest that works
  int threads = 0;            ///< 0: one for each processor
  int sweeps = 16;            ///< K, sub-sweeps a step (cpu, cuda): a power of two, 2 to 64
  InstructionSet instructions = best_instruction_set();
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
