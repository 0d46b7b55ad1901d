// What a file is, by its first bytes, and how it becomes a picture that is read as heights.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace erg::io {

/// What a file is that is no PNG.
struct FileKind {
  std::string name;        ///< "a TIFF (GeoTIFF)"
  std::string conversion;  ///< what makes a PNG of it
};

/// What the file is, decided by its content, and where that says nothing by the ending of its name: elevation data,
/// another picture, no picture at all. Nothing for a PNG, and for what is not known.
std::optional<FileKind> file_kind(const std::filesystem::path& path);

}  // namespace erg::io
