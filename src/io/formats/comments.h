// Where a file came from, for text that has comments: tables and meshes.
#pragma once

#include <string>

#include "io/config/provenance.h"

namespace erg::io {

/// The entries of a provenance as lines that begin with `mark` ("# "): one for a short text, for one of several lines
/// its name and then the lines.
std::string comments(const std::string& mark, const MetadataEntries& entries);

}  // namespace erg::io
