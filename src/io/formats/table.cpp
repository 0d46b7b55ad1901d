#include "io/formats/table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "core/errors.h"
#include "core/join.h"
#include "core/number_text.h"
#include "io/files/atomic_file.h"
#include "io/formats/comments.h"
#include "io/formats/table_head.h"

namespace erg::io {
namespace {

/// Empty where the number is unknown.
std::string cell_text(double value) { return std::isfinite(value) ? format_shortest(value) : std::string(); }

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

/// A table without rows.
std::string head_text(const std::vector<std::string>& columns, const MetadataEntries& source) {
  return comments("# ", source) + join(columns, ",") + "\n";
}

/// What lies in a table so far.
struct TableText {
  std::vector<std::string> head;  ///< comment lines
  std::string header;             ///< empty: none
  std::vector<std::string> rows;  ///< whole lines
};

TableText read_table(const std::filesystem::path& path) {
  TableText table;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (!table.header.empty()) {
      if (!file.eof()) table.rows.push_back(line);  // a last line without its end was cut off, perhaps within a number
    } else if (line.starts_with('#')) {
      table.head.push_back(line);
    } else {
      table.header = line;
    }
  }
  return table;
}

std::string whole_table(const std::vector<std::string>& columns, const std::vector<std::vector<double>>& rows,
                        const MetadataEntries& source) {
  std::string text = head_text(columns, source);
  for (const std::vector<double>& row : rows) text += row_text(row, columns.size());
  return text;
}

}  // namespace

std::string table_text(const std::vector<std::string>& columns, const std::vector<std::vector<double>>& rows,
                       const Provenance& provenance) {
  return whole_table(columns, rows, metadata(provenance));
}

void write_table(const std::filesystem::path& path, const std::vector<std::string>& columns,
                 const std::vector<std::vector<double>>& rows, const Provenance& provenance) {
  write_file_atomically(path, whole_table(columns, rows, metadata_of_file(path, provenance)));
}

TableFile::TableFile(const std::filesystem::path& path, std::size_t columns) : file_(path), columns_(columns) {}

TableFile::TableFile(const std::filesystem::path& path, const std::vector<std::string>& columns,
                     const Provenance& provenance)
    : TableFile(path, columns.size()) {
  file_.replace(head_text(columns, metadata_of_file(path, provenance)));
}

TableFile TableFile::resume(const std::filesystem::path& path, std::vector<std::string> columns,
                            const Provenance& provenance, double first_step) {
  TableFile table(path, columns.size());
  const TableText old = read_table(path);
  std::string kept;
  if (old.header.empty()) {
    kept = head_text(columns, metadata_of_file(path, provenance));
  } else {
    if (old.header != join(columns, ",")) {
      throw InputError(path.string(), "holds other columns than this run writes", "name another folder or remove it");
    }
    if (const std::string why = why_another_run(old.head, provenance, path.parent_path()); !why.empty()) {
      throw InputError(path.string(), "holds the rows of another run: " + why, "name another folder with --out");
    }
    kept = join(old.head, "\n") + "\n" + old.header + "\n";
    if (old.head.empty()) kept = old.header + "\n";
    for (const std::string& row : old.rows) {
      const double step = first_value(row, columns.size());
      if (!(step < first_step)) continue;
      table.last_ = step;
      kept += row + "\n";
    }
  }
  table.file_.replace(kept);
  return table;
}

void TableFile::add(std::span<const double> values) {
  file_.append(row_text(values, columns_));
  last_ = values.front();
}

}  // namespace erg::io
