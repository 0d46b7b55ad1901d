#include "io/table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "core/errors.h"
#include "core/exact_text.h"
#include "core/joined.h"
#include "io/atomic_file.h"
#include "io/comments.h"

namespace erg {
namespace {

/// Empty where the number is unknown.
std::string cell_text(double value) { return std::isfinite(value) ? exact_text(value) : std::string(); }

/// One line of the table.
std::string row_text(std::span<const double> values, std::size_t columns) {
  if (values.size() != columns) throw std::logic_error("a row of a table needs a value for each column");
  std::string line;
  for (std::size_t column = 0; column < columns; ++column) {
    line += (column == 0 ? "" : ",") + cell_text(values[column]);
  }
  return line + "\n";
}

/// The first value of a row; not-a-number where the row is not whole.
double first_value(const std::string& row, std::size_t columns) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (static_cast<std::size_t>(std::count(row.begin(), row.end(), ',')) + 1 != columns) return none;
  double value = 0;
  const auto result = std::from_chars(row.data(), row.data() + row.size(), value);
  return result.ec == std::errc{} ? value : none;
}

}  // namespace

std::string table_text(const std::vector<std::string>& columns, const std::vector<std::vector<double>>& rows,
                       const Provenance& provenance) {
  std::string text = comments("# ", provenance) + joined(columns, ",") + "\n";
  for (const std::vector<double>& row : rows) text += row_text(row, columns.size());
  return text;
}

void write_table(const std::filesystem::path& path, const std::vector<std::string>& columns,
                 const std::vector<std::vector<double>>& rows, const Provenance& provenance) {
  write_file_atomically(path, table_text(columns, rows, provenance));
}

TableFile::TableFile(const std::filesystem::path& path, std::size_t columns) : path_(path), columns_(columns) {}

TableFile::TableFile(const std::filesystem::path& path, std::vector<std::string> columns, const Provenance& provenance)
    : TableFile(path, columns.size()) {
  write_table(path, columns, {}, provenance);
}

TableFile TableFile::resume(const std::filesystem::path& path, std::vector<std::string> columns,
                            const Provenance& provenance, double first_step) {
  std::ifstream file(path);
  if (!file) return TableFile(path, std::move(columns), provenance);
  std::string kept;
  std::string line;
  bool header_seen = false;
  double last = std::numeric_limits<double>::quiet_NaN();
  while (std::getline(file, line)) {
    if (header_seen) {
      // A last line without its end was cut off, perhaps in the middle of a number.
      const double step = file.eof() ? std::numeric_limits<double>::quiet_NaN() : first_value(line, columns.size());
      if (!(step < first_step)) continue;
      last = step;
    }
    if (!header_seen && !line.starts_with('#')) {
      header_seen = true;
      if (line != joined(columns, ",")) {
        throw InputError(path.string(), "holds other columns than this run writes", "name another folder or remove it");
      }
    }
    kept += line + "\n";
  }
  if (!header_seen) return TableFile(path, std::move(columns), provenance);
  file.close();
  write_file_atomically(path, kept);
  TableFile table(path, columns.size());
  table.last_ = last;
  return table;
}

void TableFile::add(std::span<const double> values) {
  append_to_file(path_, row_text(values, columns_));
  last_ = values.front();
}

}  // namespace erg
