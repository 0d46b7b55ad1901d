// The numbers of a run over time, few enough to draw however long the run is.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "io/config/provenance.h"
#include "io/formats/run_numbers.h"

namespace erg::session {

/// Rows of the run's numbers (run_numbers() says which), taken every `stride` steps. When it is full every second row
/// is dropped and the stride doubles: so it spans the whole run, evenly.
class Series {
 public:
  static constexpr std::size_t most_rows = 1024;

  /// Whether a row is due after this many steps: on every multiple of the stride.
  bool due(std::int64_t step) const { return step % stride_ == 0 && (rows() == 0 || step > last_step()); }
  /// Adds a row; its first number is the step, larger than the last row's.
  void add(std::span<const double> row);
  /// Takes rows half as often from now on (measuring costs too much); rows there are stay.
  void widen() { stride_ *= 2; }
  /// Forgets everything from `step` on, after an undo.
  void cut(std::int64_t step);

  std::size_t rows() const { return rows_; }
  std::int64_t stride() const { return stride_; }
  std::int64_t last_step() const;
  double value(std::size_t row, std::size_t column) const { return values_[row * io::run_numbers().size() + column]; }
  /// One column, oldest first.
  std::vector<double> column(std::size_t column) const;

 private:
  void thin_out();

  std::int64_t stride_ = 1;
  std::size_t rows_ = 0;
  std::vector<double> values_;
};

/// The rows as CSV with their provenance. Throws InputError when it cannot be written.
void write_series(const std::filesystem::path& path, const Series& series, const io::Provenance& provenance);

}  // namespace erg::session
