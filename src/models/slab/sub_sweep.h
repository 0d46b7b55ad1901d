// What is drawn and fixed for one sub-sweep of a step, as data: every executor that sweeps starts from it, so all of
// them poll, fly and slide alike. Plain, so that it can be handed to a graphics card.
#pragma once

#include <cstdint>

#include "core/random.h"
#include "forcing/wind_frame.h"

namespace erg::models {

struct SlabLaw;
/// Edge classes: edges of one class share no cell.
enum EdgeClass : std::uint8_t {
  along_even,
  along_odd,
  across_even,
  across_odd,
  rising_even,  ///< diagonal (u, v) - (u + 1, v + 1), v even
  rising_odd,
  falling_even,  ///< diagonal (u, v) - (u - 1, v + 1), v even
  falling_odd
};
ERG_CELL_RULE bool is_diagonal(EdgeClass edges) { return edges >= rising_even; }

/// A share of all polls (SubSweep::poll_share_16).
inline constexpr std::uint32_t whole_share_16 = 65536;

/// One sub-sweep.
struct SubSweep {
  int sweeps = 16;               ///< K
  std::uint64_t sweep_word = 0;  ///< random word of (seed, step, sub-sweep)
  std::uint64_t poll_word = 0;   ///< the same for polls: of the whole round where polling is non-repeated
  std::uint32_t poll_share_16 = whole_share_16;  ///< less: only such a share of the polls, * 65536, is carried out
  bool permuted = false;                         ///< non-repeated polling
  std::uint8_t polled_row[256] = {};             ///< then: rows in [0, K), one for each random byte

  bool oblique = false;
  std::int64_t drift = 0;  ///< columns that a line moves over the length of the grid
  std::int64_t phase = 0;  ///< in [0, length)
  /// Rows after which a line of a torus meets the same cells again: over the length of the grid it moves by whole
  /// columns, so that after some turns it is back; or `longest_shadow` lengths. No shadow comes from further away.
  std::int64_t rows_around = 0;

  std::uint32_t p_sand_16 = 0;  ///< chance * 65536
  std::uint32_t p_bare_16 = 0;
  bool lift_in_shadow = true;
  std::uint32_t row_fall = 0;  ///< ShadowFalls, 1/256 slabs
  std::uint32_t next_fall = 0;
  std::uint32_t second_fall = 0;
  int wall_step = 0;  ///< slabs: bedrock standing higher than this over the ground before it is a wall
  double inflow = 0;  ///< slabs entering per line and sub-sweep

  int edge_classes = 4;
  std::uint8_t order[8] = {};  ///< classes of sliding edges (EdgeClass) in the order of this sub-sweep
};

/// Rows of a block of lines: each line is polled in at most one row of each block.
ERG_CELL_RULE int poll_rows(const SubSweep& sweep) { return sweep.permuted ? sweep.sweeps : sweep.sweeps / 2; }

/// What non-repeated polling draws once for a round of K sub-sweeps: 256 permutations of K rows.
struct PolledRows {
  static constexpr int permutations = 256;  ///< one for each random byte

  std::uint8_t of_sweep[64][permutations];  ///< the row of a block that each of the K polls

  /// Draws the permutations [first, end): threads share them out. `draw`: what random_word calls these words.
  void permute(StepKey key, std::uint64_t round, std::uint64_t draw, int sweeps, int first, int end);
  /// The same for what sub_sweep needs, in the round that sub-sweep number `sweep` belongs to.
  void draw(StepKey key, int sweep, int sweeps, int first = 0, int end = permutations);
};

/// How far a step has come.
struct StepAccount {
  int sweep = 0;                ///< sub-sweeps done
  int idle = 0;                 ///< of these, those since the last lift
  std::int64_t lifts = 0;       ///< of all of them
  std::int64_t last_lifts = 0;  ///< of the last one
  bool complete = false;        ///< the last one was shortened to reach the lifts wanted

  /// Books the sub-sweep that was just done.
  void book(const SubSweep& done, std::int64_t lifted);
};

/// The next sub-sweep of the step `key`, of `sweeps` (K) that make a step. `rows` are drawn for its round;
/// where polling is repeated nobody looks at them.
SubSweep sub_sweep(const SlabLaw& law, const forcing::WindFrame& frame, bool open, StepKey key,
                   const StepAccount& account, int sweeps, const PolledRows& rows);

/// HopCurve::rounding of a step; over a few steps in a row its values lie evenly in [0, 1).
double hop_rounding(StepKey key);

/// A critical step that 16 bits can add to any height; steeper slopes than this need no test.
inline constexpr int longest_step = 25000;

/// Forced erosion gives up after this many rounds of K sub-sweeps without a lift.
inline constexpr int idle_rounds = 4;

/// Whether a step goes on. Under forced erosion it does until as many slabs are lifted as there are cells: when the
/// next sub-sweep would lift more than are wanted, by the last one's count, only such a share of its polls is carried
/// out, and it ends the step.
bool goes_on(const SlabLaw& law, const StepAccount& account, std::int64_t cells, int sweeps);

}  // namespace erg::models
