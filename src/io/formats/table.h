// A run's numbers as a table (CSV), one row at a time.
#pragma once

#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "io/config/provenance.h"
#include "io/files/growing_file.h"

namespace erg::io {

/// A whole table as text, for printing: what write_table writes, with the whole config in its head, however long.
std::string table_text(const std::vector<std::string>& columns, const std::vector<std::vector<double>>& rows,
                       const Provenance& provenance);

/// Writes a whole table at once: comment lines (#) with the provenance, one header, then rows, each with as many values
/// as there are columns. Numbers are in the shortest form that reads back exactly; not-a-number stays empty. Throws
/// WriteError; an older file is then untouched.
void write_table(const std::filesystem::path& path, const std::vector<std::string>& columns,
                 const std::vector<std::vector<double>>& rows, const Provenance& provenance);

/// A table of this form that grows. Each row reaches the file at once and whole, so that a run that is cut short leaves
/// its numbers. As long as one of these lives no other run can take the file.
class TableFile {
 public:
  /// Starts the file anew. Throws WriteError when it cannot be written, InputError where another run writes it.
  TableFile(const std::filesystem::path& path, const std::vector<std::string>& columns, const Provenance& provenance);
  /// Goes on with a file of the same columns (a resumed run), or starts one where there is none. Rows whose first
  /// column is `first_step` or more are dropped: the resumed run writes them again. So are rows that are not whole.
  /// Throws InputError for other columns, and where its head tells of a run that this one cannot be the rest of
  /// (needs_new_terrain).
  static TableFile resume(const std::filesystem::path& path, std::vector<std::string> columns,
                          const Provenance& provenance, double first_step);

  /// Adds one row: as many values as columns. Throws WriteError; the file then ends with the row before.
  void add(std::span<const double> values);
  /// The first value of the last row; not-a-number before there is one.
  double last() const { return last_; }

 private:
  TableFile(const std::filesystem::path& path, std::size_t columns);

  GrowingFile file_;
  std::size_t columns_ = 0;
  double last_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace erg::io
