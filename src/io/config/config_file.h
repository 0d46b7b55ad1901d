// Config files: everything a run needs, as JSON.
//
//   { "erg": 1, "model": "momiji", "grid": {"nx": 512}, "scene": {...}, "parameters": {...the model's own...},
//     "wind": {"bearing": "W", "strength": 5}, "run": {"steps": 1000} }
//
// Comments (`// ...`, `/* ... */`) are passed over. Only "erg" (the version of the format) and "model" must be there;
// what is absent has its default. The wind is constant, as above, or a list: {"seasons": [{"bearing": "NE", "first": 5,
// "last": 8, "steps": 80, "curve": [[x, y], [x, y]]}]}, where "strength" stands for first and last the same. Saving
// writes what differs from the defaults, and the few values that a reader wants to see in any case.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/config.h"

namespace erg::io {

/// Reads a config from a file. A relative picture path, which in the file is relative to the file's folder, comes out
/// relative to the working folder. Throws one InputError with every mistake in the file, a missing picture among them,
/// each at `file:line`. "-" is standard input; of a config that comes from there or through a pipe, pictures are
/// relative to the working folder. `notes`, where given, gets what is worth telling: that comments are not kept.
sim::Config read_config(const std::filesystem::path& path, std::vector<std::string>* notes = nullptr);

/// The same from text; `name` stands for the file in mistakes. Leaves the picture's path as it is and does not look for
/// it.
sim::Config parse_config(std::string_view text, const std::string& name);

/// The config as the text of a file: parse_config gives the same config back. The picture's path is written as it is.
std::string config_text(const sim::Config& config);

/// Writes the config, whole or not at all, with the picture's path relative to the file's folder (an absolute path
/// stays so unless the picture lies in that folder). Throws InputError when it cannot.
void write_config(const std::filesystem::path& path, const sim::Config& config);

/// The JSON Schema (draft 2020-12) of config files, derived from the declarations of all parameters.
std::string config_schema();

}  // namespace erg::io
