// A run, saved so that it goes on to the same bits.
#pragma once

#include <filesystem>

#include "sim/config.h"
#include "sim/simulation.h"

namespace erg::io {

/// What a checkpoint holds.
struct Saved {
  sim::Config config;
  sim::RunState state;
};

/// The version of the checkpoint format that this program writes; it reads no other.
inline constexpr std::uint32_t checkpoint_version = 1;

/// Writes config, step, totals, account, layers and fields, with a checksum; whole or not at all. Throws InputError
/// when it cannot be written.
void write_checkpoint(const std::filesystem::path& path, const sim::Config& config, const sim::RunState& state);

/// Reads a checkpoint. A missing, foreign, newer, truncated or damaged file, one that holds what no run of its config
/// can have made, and one whose run would not fit into the memory that is free, is refused with an InputError.
Saved read_checkpoint(const std::filesystem::path& path);

}  // namespace erg::io
