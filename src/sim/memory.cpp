#include "sim/memory.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <new>

#include "models/model.h"
#include "process/allowance.h"

namespace erg::sim {

using models::find_model;

namespace {

/// What a run takes beside what grows with its grid: threads, tables, pictures.
constexpr std::uint64_t beside_the_grid = std::uint64_t{160} << 20;

struct Size {
  std::int64_t nx = 0;
  std::int64_t ny = 0;

  std::uint64_t cells() const { return static_cast<std::uint64_t>(nx) * static_cast<std::uint64_t>(ny); }
  std::string text() const { return std::to_string(nx) + " x " + std::to_string(ny); }
};

Size size_of(const Config& config) { return {config.grid.integer("nx"), config.grid.integer("ny")}; }

std::uint64_t terrain_bytes_a_cell(const Config& config) {
  return 2 * sizeof(std::int32_t) + find_model(config.model).fields.size() * sizeof(float);
}

/// What executor and model keep of a cell besides the terrain. An executor keeps planes of one or two bytes, and
/// `serial` an order of cells.
std::uint64_t working_bytes_a_cell(const Config& config) {
  const std::uint64_t executor = config.run.text("executor") == "serial" ? 6 : 3;
  return executor + find_model(config.model).working_bytes;
}

/// What pictures keep of a cell until the terrain is made: their values, and of one at a time where they have no data.
std::uint64_t picture_bytes_a_cell(const Config& config) {
  constexpr std::uint64_t bytes = sizeof(float) + 1;
  return (wanted_path(config.scene) != nullptr ? bytes : 0) + (wanted_path(config.parameters) != nullptr ? bytes : 0);
}

/// Bytes of all runs and copies together for each cell.
std::uint64_t bytes_a_cell(std::span<const Config> configs, int copies) {
  std::uint64_t bytes = 0;
  for (const Config& config : configs) {
    // The executor and the model get to work when the pictures are gone.
    bytes += std::max(working_bytes_a_cell(config), picture_bytes_a_cell(config)) +
             static_cast<std::uint64_t>(copies + 1) * terrain_bytes_a_cell(config);
  }
  return bytes;
}

/// The largest grid of the same shape, in steps of 64 cells of its longer side.
Size largest_that_fits(Size wanted, std::uint64_t cells) {
  constexpr std::int64_t step = 64;
  const std::int64_t longer = std::max(wanted.nx, wanted.ny);
  const double share = std::sqrt(static_cast<double>(cells) / static_cast<double>(wanted.cells()));
  const auto side = static_cast<std::int64_t>(static_cast<double>(longer) * share) / step * step;
  return {std::max<std::int64_t>(1, wanted.nx * side / longer), std::max<std::int64_t>(1, wanted.ny * side / longer)};
}

}  // namespace

std::uint64_t memory_of_run(const Config& config) { return size_of(config).cells() * bytes_a_cell({&config, 1}, 0); }

std::uint64_t free_memory() { return process::allowed_memory(); }

std::string memory_text(std::uint64_t bytes) {
  constexpr double gibi = 1024.0 * 1024 * 1024;
  char text[32];
  const double amount = static_cast<double>(bytes) / gibi;
  std::snprintf(text, sizeof text, amount >= 1 ? "%.1f GiB" : "%.0f MiB", amount >= 1 ? amount : amount * 1024);
  return text;
}

void check_memory(std::span<const Config> configs, int copies, std::uint64_t free) {
  if (configs.empty()) return;
  const Size size = size_of(configs.front());
  const std::uint64_t a_cell = bytes_a_cell(configs, copies);
  const std::uint64_t needed = a_cell * size.cells() + beside_the_grid;
  if (needed <= free) return;
  const Size fits = largest_that_fits(size, (free > beside_the_grid ? free - beside_the_grid : 0) / a_cell);
  throw InputError(
      "grid", size.text() + " cells need " + memory_text(needed) + " of memory, and " + memory_text(free) + " are free",
      fits.cells() > 4096 ? "a grid of " + fits.text() + " would fit" : "close other programs");
}

std::string problem_of(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) == nullptr) return error.what();
  return "there is not enough memory for this; take a smaller grid or close other programs";
}

}  // namespace erg::sim
