#include "io/formats/png.h"

#include <png.h>

#include <bit>
#include <csetjmp>
#include <vector>

#include "core/errors.h"
#include "io/files/atomic_file.h"

namespace erg::io {

using picture::RgbaImage;
using picture::RgbImage;

namespace {

/// Pixels as PNG has them: rows from the top, samples of 8 or 16 bits in the machine's byte order.
struct PngPixels {
  int width = 0;
  int height = 0;
  int bits = 8;      ///< 8 or 16 a sample
  int channels = 3;  ///< 1 grey, 3 colour, 4 colour with opacity
  const void* first = nullptr;
};

void append_bytes(png_structp png, png_bytep data, png_size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), count);
}

void ignore_flush(png_structp) {}
void ignore_warning(png_structp, png_const_charp) {}
[[noreturn]] void jump_back(png_structp png, png_const_charp) { png_longjmp(png, 1); }

std::vector<png_text> text_chunks(const MetadataEntries& entries) {
  std::vector<png_text> chunks;
  for (const auto& [name, text] : entries) {
    png_text chunk{};
    chunk.compression = PNG_ITXT_COMPRESSION_NONE;  // international text: the config is UTF-8
    chunk.key = const_cast<char*>(name.c_str());    // libpng does not write to it
    chunk.text = const_cast<char*>(text.c_str());
    chunk.itxt_length = text.size();
    chunks.push_back(chunk);
  }
  return chunks;
}

int colour_type(int channels) {
  return channels == 1 ? PNG_COLOR_TYPE_GRAY : channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB;
}

// libpng reports an error by jumping back here, so nothing in this function may need a destructor.
bool write_all(png_structp png, png_infop info, const PngPixels& pixels, std::vector<png_text>& chunks,
               std::vector<png_bytep>& rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_IHDR(png, info, static_cast<png_uint_32>(pixels.width), static_cast<png_uint_32>(pixels.height), pixels.bits,
               colour_type(pixels.channels), PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_text(png, info, chunks.data(), static_cast<int>(chunks.size()));
  png_write_info(png, info);
  if (pixels.bits == 16 && std::endian::native == std::endian::little) png_set_swap(png);
  png_write_image(png, rows.data());
  png_write_end(png, nullptr);
  return true;
}

/// The whole file as bytes. Throws InputError with `path` as the place when the encoder refuses.
std::string encode_png(const PngPixels& pixels, const MetadataEntries& entries, const std::filesystem::path& path) {
  std::string bytes;
  std::vector<png_text> chunks = text_chunks(entries);
  std::vector<png_bytep> rows(static_cast<std::size_t>(pixels.height));
  const std::size_t row_bytes = static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.channels) *
                                static_cast<std::size_t>(pixels.bits / 8);
  auto* first = static_cast<png_bytep>(const_cast<void*>(pixels.first));  // libpng does not write to it
  for (std::size_t row = 0; row < rows.size(); ++row) rows[row] = first + row * row_bytes;

  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, jump_back, ignore_warning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  bool written = false;
  if (info != nullptr) {
    png_set_write_fn(png, &bytes, append_bytes, ignore_flush);
    written = write_all(png, info, pixels, chunks, rows);
  }
  png_destroy_write_struct(&png, &info);
  if (!written) throw InputError(path.string(), "the picture could not be encoded as PNG", "choose a smaller picture");
  return bytes;
}

bool is_opaque(const RgbaImage& image) {
  for (std::size_t opacity = 3; opacity < image.pixels.size(); opacity += 4) {
    if (image.pixels[opacity] != 255) return false;
  }
  return true;
}

}  // namespace

void write_png(const std::filesystem::path& path, const RgbImage& image, const MetadataEntries& entries) {
  write_file_atomically(path, encode_png({image.width, image.height, 8, 3, image.pixels.data()}, entries, path));
}

void write_png(const std::filesystem::path& path, const RgbaImage& image, const MetadataEntries& entries) {
  if (is_opaque(image)) return write_png(path, picture::over(image, {}), entries);
  write_file_atomically(path, encode_png({image.width, image.height, 8, 4, image.pixels.data()}, entries, path));
}

void write_png(const std::filesystem::path& path, const GreyImage& image, const MetadataEntries& entries) {
  write_file_atomically(path, encode_png({image.width, image.height, 16, 1, image.pixels.data()}, entries, path));
}

void write_run_png(const std::filesystem::path& path, const RgbImage& image, const Provenance& provenance) {
  write_png(path, image, metadata_of_file(path, provenance));
}

void write_run_png(const std::filesystem::path& path, const RgbaImage& image, const Provenance& provenance) {
  write_png(path, image, metadata_of_file(path, provenance));
}

}  // namespace erg::io
