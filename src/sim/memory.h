// How much memory a run takes, and how much there is: said before a grid is made that does not fit.
#pragma once

#include <cstdint>
#include <exception>
#include <span>
#include <string>

#include "sim/config.h"

namespace erg::sim {

/// Bytes that a run of this config takes at most while it steps: the terrain, the executor's planes, what the model
/// keeps. What does not grow with the grid is left out. tests/cli/trust_test.cpp holds it against what runs take.
std::uint64_t memory_of_run(const Config& config);

/// Bytes that this process may still take (process/allowance.h).
std::uint64_t free_memory();

/// "2.3 GiB", "310 MiB".
std::string memory_text(std::uint64_t bytes);

/// Whether runs of these configs, with so many further copies of each one's terrain, fit into `free` bytes. Throws
/// InputError where not: what is needed, what is free, and the largest grid of the same shape that would fit.
void check_memory(std::span<const Config> configs, int copies, std::uint64_t free);

/// What went wrong, for people: the error's own text, or that the memory did not suffice.
std::string problem_of(const std::exception& error);

}  // namespace erg::sim
