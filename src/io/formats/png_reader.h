// PNG files, read row by row: the program's only decoder of them.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "io/config/provenance.h"

namespace erg::io {

/// How a PNG keeps its colours.
enum class PngColours { grey, palette, colour };

/// Larger pictures are refused before their pixels are read.
inline constexpr int largest_png_side = 1 << 16;

/// A PNG at work. Every checksum is looked at: of each chunk and of the pixels.
class PngReader {
 public:
  /// Opens the file and reads what stands before the pixels. Throws InputError for a file that is missing, no PNG, or
  /// damaged, and std::bad_alloc where the memory does not suffice: that is never told as damage.
  explicit PngReader(const std::filesystem::path& path);
  ~PngReader();
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }
  PngColours colours() const { return colours_; }
  /// Whether pixels can be transparent.
  bool has_opacity() const { return opacity_; }
  /// Bytes that are held of the pixels while they are read: a row, or all of them where the file is interlaced.
  std::uint64_t held_bytes() const;
  bool interlaced() const { return interlaced_; }

  /// Reads all pixels, once; `take` gets each row's number, 0 at the top, and its samples: `channels()` for each pixel,
  /// from 0 to 65535 whatever the file's depth, the opacity last.
  void read_rows(const std::function<void(int row, std::span<const std::uint16_t> samples)>& take);
  /// 1 grey or 3 colours, and 1 more with opacity. A palette's colours count as such.
  int channels() const { return channels_; }

  /// The text chunks read so far: after read_rows those behind the pixels too.
  MetadataEntries text() const;

 private:
  struct Library;  // the decoder's own state

  [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const;
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::unique_ptr<Library> library_;
  int width_ = 0;
  int height_ = 0;
  int channels_ = 1;
  PngColours colours_ = PngColours::grey;
  bool opacity_ = false;
  bool interlaced_ = false;
};

/// The text chunks of a PNG that stand before its pixels. Throws as PngReader does.
MetadataEntries read_png_metadata(const std::filesystem::path& path);

}  // namespace erg::io
