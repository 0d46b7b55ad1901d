// What a run can go on from. Programs that link the library may build configs and states by hand; what they get wrong
// is an InputError here, before an executor or a model relies on it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim/simulation.h"

namespace erg::sim {

/// The highest a surface may stand, and the lowest bedrock may lie, in quanta either side of 0: differences of heights
/// are 32-bit numbers too.
inline constexpr std::int32_t largest_height = (std::int32_t{1} << 30) - 1;
/// The largest value of a field, which may count a cell's slabs.
inline constexpr float largest_field_value = 0x1p30f;
/// The largest count of a ledger or of a run's totals: sums of a few are still whole numbers of 64 bits.
inline constexpr std::int64_t largest_count = std::int64_t{1} << 60;

/// Throws InputError where a config is none of its model (every group has the values that the model declares, within
/// their ranges) or its weather cannot be (no season, seasons without steps, numbers that are not finite).
void check_config(const Config& config);

/// What is wrong with a terrain as that of a run of this config, whose model's slabs are `quantum` m high; or nothing.
/// Other sides, cell size, slab height or boundary than the config's, layers of different extents, fields that are not
/// the model's, cells that hold less than nothing, heights and values out of range. The fields may be absent where
/// `fields_may_come` (a model makes them when it begins).
std::optional<std::string> terrain_problem(const Config& config, double quantum, const Terrain& terrain,
                                           bool fields_may_come = false);

/// Whether the counts of an account are such that their sums are whole numbers of 64 bits.
bool counts_in_range(const MassLedger& ledger);

/// What is wrong with a terrain's account: counts out of range, or material that it does not know of.
std::optional<std::string> ledger_problem(const Terrain& terrain);

/// Throws InputError where a run of this config cannot go on from the state.
void check_state(const Config& config, double quantum, const RunState& state);

}  // namespace erg::sim
