// Options that accept a few words.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace erg::app {

/// Accepts these words only; another is refused with the nearest of them.
CLI::Validator one_of(const std::vector<std::string>& words);

}  // namespace erg::app
