// A run's numbers as a table (CSV), one row at a time.
#pragma once

#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "io/provenance.h"

namespace erg {

/// A CSV file that grows: comment lines (#) with the provenance, one header, then rows. Each row reaches the file at
/// once, so that a run that is cut short leaves its numbers.
class TableFile {
 public:
  /// Starts the file anew. Throws InputError when it cannot be written.
  TableFile(const std::filesystem::path& path, std::vector<std::string> columns, const Provenance& provenance);
  /// Goes on with a file of the same columns (a resumed run), or starts one where there is none. Rows whose first
  /// column is `first_step` or more are dropped: the resumed run writes them again. Throws InputError for other
  /// columns.
  static TableFile resume(const std::filesystem::path& path, std::vector<std::string> columns,
                          const Provenance& provenance, double first_step);

  /// Adds one row: as many values as columns, in the shortest form that reads back exactly; not-a-number stays empty.
  void add(std::span<const double> values);

 private:
  TableFile(const std::filesystem::path& path, std::size_t columns);

  std::filesystem::path path_;
  std::size_t columns_ = 0;
  std::ofstream stream_;
};

}  // namespace erg
