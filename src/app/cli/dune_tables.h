// What `erg measure` prints: the dunes of one or more moments as text, CSV and JSON.
#pragma once

#include <string>
#include <vector>

#include "io/config/provenance.h"
#include "io/formats/dune_numbers.h"
#include "sim/config.h"

namespace erg::app {

/// A table of one moment's dunes, and what they are together.
std::string dunes_text(const io::MeasuredDunes& moment);
/// A table with a row for each moment.
std::string fields_text(const std::vector<io::MeasuredDunes>& moments);

/// CSV with a row for each dune and moment (dune_numbers), or for each moment (field_numbers).
std::string dunes_csv(const std::vector<io::MeasuredDunes>& moments, const io::Provenance& source);
std::string fields_csv(const std::vector<io::MeasuredDunes>& moments, const io::Provenance& source);

/// One JSON object: "moments", each with the numbers of all its dunes together, the rule by which they were found, and
/// each of them under "each"; "units" and "units_of_each"; version and config. Unknown numbers are null.
std::string dunes_json(const std::vector<io::MeasuredDunes>& moments, const sim::Config& config);

}  // namespace erg::app
