#include "session/series.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "io/formats/table.h"

namespace erg::session {

using io::run_numbers;

std::int64_t Series::last_step() const { return rows_ == 0 ? -1 : static_cast<std::int64_t>(value(rows_ - 1, 0)); }

void Series::add(std::span<const double> row) {
  const std::size_t columns = run_numbers().size();
  if (row.size() != columns) throw std::logic_error("a row of a series needs every number");
  if (rows_ == most_rows) {
    stride_ *= 2;
    thin_out();
  }
  values_.insert(values_.end(), row.begin(), row.end());
  ++rows_;
}

/// Keeps the rows that the present stride would have taken.
void Series::thin_out() {
  const std::size_t columns = run_numbers().size();
  std::size_t kept = 0;
  for (std::size_t row = 0; row < rows_; ++row) {
    if (static_cast<std::int64_t>(value(row, 0)) % stride_ != 0) continue;
    std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(row * columns), columns,
                values_.begin() + static_cast<std::ptrdiff_t>(kept * columns));
    ++kept;
  }
  rows_ = kept;
  values_.resize(rows_ * columns);
}

void Series::cut(std::int64_t step) {
  while (rows_ > 0 && last_step() >= step) --rows_;
  values_.resize(rows_ * run_numbers().size());
}

std::vector<double> Series::column(std::size_t column) const {
  std::vector<double> values(rows_);
  for (std::size_t row = 0; row < rows_; ++row) values[row] = value(row, column);
  return values;
}

void write_series(const std::filesystem::path& path, const Series& series, const io::Provenance& provenance) {
  std::vector<std::string> columns;
  for (const io::RunNumber& number : run_numbers()) columns.push_back(number.key);
  std::vector<std::vector<double>> rows(series.rows());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t column = 0; column < columns.size(); ++column) rows[i].push_back(series.value(i, column));
  }
  io::write_table(path, columns, rows, provenance);
}

}  // namespace erg::session
