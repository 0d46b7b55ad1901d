// Random numbers as a function, not a stream: the same key always gives the same number, so a result depends on no
// order of evaluation. One key has five parts: seed, step, sub-sweep, cell (or line and row) and draw.
#pragma once

#include <cstdint>

#include "core/subset.h"

namespace erg {

#include "core/random.k"

/// SplitMix64's finaliser (Steele, Lea & Flood 2014): a bijection of 64-bit words that mixes every bit.
ERG_CELL_RULE std::uint64_t mix64(std::uint64_t word) {
  word += 0x9e3779b97f4a7c15u;
  word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9u;
  word = (word ^ (word >> 27)) * 0x94d049bb133111ebu;
  return word ^ (word >> 31);
}

/// The moment of a draw: which run, which time step.
struct StepKey {
  std::uint64_t seed = 0;
  std::uint64_t step = 0;
};

/// A 64-bit random word for a step and up to three further key parts.
ERG_CELL_RULE std::uint64_t random_word(StepKey key, std::uint64_t sweep, std::uint64_t cell, std::uint64_t draw) {
  return mix64(mix64(mix64(mix64(key.seed) ^ key.step) ^ (sweep << 32 | draw)) ^ cell);
}

/// The same as a number in [0, 1) with 53 random bits.
ERG_CELL_RULE double random_unit(StepKey key, std::uint64_t sweep, std::uint64_t cell, std::uint64_t draw) {
  return static_cast<double>(random_word(key, sweep, cell, draw) >> 11) * 0x1.0p-53;
}

/// The same as an integer in [0, bound); bound must be positive.
ERG_CELL_RULE std::uint32_t random_below(StepKey key, std::uint64_t sweep, std::uint64_t cell, std::uint64_t draw,
                                         std::uint32_t bound) {
  return static_cast<std::uint32_t>(((random_word(key, sweep, cell, draw) >> 32) * bound) >> 32);
}

}  // namespace erg
