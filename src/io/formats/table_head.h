// The head of a table: which run its rows are of.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/config/provenance.h"

namespace erg::io {

/// Why the rows under these comment lines are not of the run of `provenance`, however that run may have been changed on
/// its way: another model, seed, grid or scene, or another value of what is read only at the start. Empty where nothing
/// speaks against it. `folder`: where a config that is too long for the head lies.
std::string why_another_run(const std::vector<std::string>& head, const Provenance& provenance,
                            const std::filesystem::path& folder);

}  // namespace erg::io
