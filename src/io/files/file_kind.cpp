#include "io/files/file_kind.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string_view>

namespace erg::io {
namespace {

using namespace std::string_view_literals;

// What converts, said in one way. IN, OUT, LOW and HIGH are for the reader to fill in.
constexpr std::string_view by_gdal =
    "convert it: gdal_translate -of PNG -ot UInt16 -scale LOW HIGH 0 65535 IN OUT.png (gdalinfo -mm IN tells LOW and "
    "HIGH), and set image_low to LOW and image_high to HIGH";
constexpr std::string_view by_magick =
    "convert it: magick IN -colorspace Gray -depth 16 OUT.png (ImageMagick 6: convert in place of magick)";
constexpr std::string_view by_magick_raw =
    "convert it: magick -size WIDTHxHEIGHT -depth 16 -endian LSB gray:IN OUT.png (MSB where its numbers begin with the "
    "large byte; ImageMagick 6: convert in place of magick)";
constexpr std::string_view by_python =
    "convert it: python3 -c \"import numpy, PIL.Image; a = numpy.load('IN').astype(float); a -= a.min(); "
    "PIL.Image.fromarray((a / a.max() * 65535).astype('uint16')).save('OUT.png')\", and set image_low and image_high "
    "to "
    "the least and the largest value";
constexpr std::string_view by_unpacking = "unpack it, and give the heights in it";
constexpr std::string_view by_fetching = "fetch the picture itself";

struct Signature {
  std::size_t at;
  std::string_view bytes;
  std::string_view name;
  std::string_view conversion;
};

constexpr std::array signatures{
    Signature{0, "II*\0"sv, "a TIFF (GeoTIFF)", by_gdal},
    Signature{0, "MM\0*"sv, "a TIFF (GeoTIFF)", by_gdal},
    Signature{0, "II+\0"sv, "a BigTIFF (GeoTIFF)", by_gdal},
    Signature{0, "MM\0+"sv, "a BigTIFF (GeoTIFF)", by_gdal},
    Signature{0, "\x93NUMPY"sv, "a NumPy array (.npy)", by_python},
    Signature{0, "\x76\x2f\x31\x01"sv, "an OpenEXR picture", by_gdal},
    Signature{0, "\x89HDF"sv, "an HDF5 or netCDF file", by_gdal},
    Signature{0, "CDF"sv, "a netCDF file", by_gdal},
    Signature{0, "EHFA_HEADER_TAG"sv, "an ERDAS Imagine raster", by_gdal},
    Signature{0, "DSAA"sv, "a Surfer grid", by_gdal},
    Signature{0, "DSBB"sv, "a Surfer grid", by_gdal},
    Signature{0, "DSRB"sv, "a Surfer grid", by_gdal},
    Signature{0, "\0\0\0\x0cjP  "sv, "a JPEG 2000 picture", by_gdal},
    Signature{0, "\xff\xd8\xff"sv, "a JPEG, which keeps 256 heights and blurs them", by_magick},
    Signature{0, "BM"sv, "a BMP picture", by_magick},
    Signature{0, "GIF8"sv, "a GIF", by_magick},
    Signature{8, "WEBP"sv, "a WebP picture", by_magick},
    Signature{4, "ftyp"sv, "a HEIF or AVIF picture, or a film", by_magick},
    Signature{0, "8BPS"sv, "a Photoshop file", by_magick},
    Signature{0, "gimp xcf"sv, "a GIMP file", "export a 16-bit grey PNG from GIMP"},
    Signature{0, "P2"sv, "a PGM picture", by_magick},
    Signature{0, "P5"sv, "a PGM picture", by_magick},
    Signature{0, "P3"sv, "a PPM picture", by_magick},
    Signature{0, "P6"sv, "a PPM picture", by_magick},
    Signature{0, "PF\n"sv, "a PFM picture", by_magick},
    Signature{0, "Pf\n"sv, "a PFM picture", by_magick},
    Signature{0, "#?RADIANCE"sv, "a Radiance picture (HDR)", by_magick},
    Signature{0, "DDS "sv, "a DDS texture", by_magick},
    Signature{0, "LASF"sv, "a cloud of points (LAS)",
              "make a raster of it first, by pdal or lastools, and of that a PNG"},
    Signature{0, "PK\x03\x04"sv, "a ZIP archive", by_unpacking},
    Signature{0, "\x1f\x8b"sv, "packed by gzip", by_unpacking},
    Signature{0, "BZh"sv, "packed by bzip2", by_unpacking},
    Signature{0,
              "\xfd"
              "7zXZ"sv,
              "packed by xz", by_unpacking},
    Signature{0, "7z\xbc\xaf\x27\x1c"sv, "a 7-Zip archive", by_unpacking},
    Signature{0, "%PDF"sv, "a PDF", by_fetching},
    Signature{0, "version https://git-lfs"sv, "a pointer to a file kept elsewhere (Git LFS)",
              "fetch the file: git lfs pull"},
};

struct Ending {
  std::string_view ending;
  std::string_view name;
  std::string_view conversion;
};

/// What has no mark of its own.
constexpr std::array endings{
    Ending{".r16", "raw 16-bit heights", by_magick_raw}, Ending{".raw", "raw heights", by_magick_raw},
    Ending{".hgt", "a tile of SRTM heights", by_gdal},   Ending{".flt", "raw floating-point heights", by_gdal},
    Ending{".bil", "a raw raster (BIL)", by_gdal},       Ending{".bsq", "a raw raster (BSQ)", by_gdal},
    Ending{".bin", "a raw raster", by_magick_raw},       Ending{".img", "a raster", by_gdal},
    Ending{".dem", "a USGS elevation model", by_gdal},   Ending{".dt0", "a DTED elevation model", by_gdal},
    Ending{".dt1", "a DTED elevation model", by_gdal},   Ending{".dt2", "a DTED elevation model", by_gdal},
    Ending{".xyz", "a list of points", by_gdal},         Ending{".csv", "a table", by_gdal},
    Ending{".tga", "a TGA picture", by_magick},
};

std::string lowered(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return text;
}

/// The first word of a text, with small letters.
std::string first_word(std::string_view start) {
  if (start.starts_with("\xef\xbb\xbf")) start.remove_prefix(3);
  const std::size_t from = std::min(start.find_first_not_of(" \t\r\n"), start.size());
  const std::size_t to = std::min(start.find_first_of(" \t\r\n>=", from), start.size());
  return lowered(std::string(start.substr(from, to - from)));
}

std::optional<FileKind> text_kind(std::string_view start) {
  const std::string word = first_word(start);
  for (const std::string_view esri : {"ncols"sv, "nrows"sv, "xllcorner"sv, "xllcenter"sv, "cellsize"sv}) {
    if (word == esri) return FileKind{"an ESRI ASCII grid", std::string(by_gdal)};
  }
  if (word.starts_with("<!doctype") || word.starts_with("<html")) {
    return FileKind{"a web page, perhaps that of the picture", std::string(by_fetching)};
  }
  if (word.starts_with("<svg") || word.starts_with("<?xml")) {
    return FileKind{"an XML file", "give the raster that belongs to it, as a PNG"};
  }
  return std::nullopt;
}

/// Sixteen bits for each point of a square, and nothing else.
bool is_square_of_16_bits(std::uintmax_t bytes) {
  const auto side = static_cast<std::uintmax_t>(std::lround(std::sqrt(static_cast<double>(bytes / 2))));
  return side >= 8 && bytes == 2 * side * side;
}

}  // namespace

std::optional<FileKind> file_kind(const std::filesystem::path& path) {
  std::string start(256, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  if (start.empty()) return FileKind{"an empty file", std::string(by_fetching)};
  if (start.starts_with("\x89PNG")) return std::nullopt;
  for (const Signature& signature : signatures) {
    const bool fits =
        start.size() > signature.at && start.compare(signature.at, signature.bytes.size(), signature.bytes) == 0;
    if (fits) return FileKind{std::string(signature.name), std::string(signature.conversion)};
  }
  if (auto kind = text_kind(start)) return kind;
  const std::string ending = lowered(path.extension().string());
  const auto known = std::ranges::find(endings, ending, &Ending::ending);
  if (known != endings.end()) return FileKind{std::string(known->name), std::string(known->conversion)};
  std::error_code failed;
  if (is_square_of_16_bits(std::filesystem::file_size(path, failed)) && !failed) {
    return FileKind{"perhaps raw 16-bit heights", std::string(by_magick_raw)};
  }
  return std::nullopt;
}

}  // namespace erg::io
