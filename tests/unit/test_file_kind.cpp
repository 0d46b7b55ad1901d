// What is given in place of a PNG is known by its content, and the message says what makes a PNG of it.
#include "io/files/file_kind.h"

#include <gtest/gtest.h>

#include "io/formats/heightmap.h"
#include "message.h"
#include "temporary_folder.h"

namespace erg {

using io::file_kind;
using io::FileKind;
using io::read_height_picture;

namespace {

struct Given {
  std::string name;   ///< of the file
  std::string bytes;  ///< that it begins with
  std::string told;   ///< what it is
  std::string way;    ///< part of the conversion
};

const std::vector<Given>& given_files() {
  using namespace std::string_literals;
  static const std::vector<Given> files{
      {"dem.tif", "II*\0\x08\0\0\0"s, "GeoTIFF", "gdal_translate"},
      {"dem.tif", "MM\0*\0\0\0\x08"s, "GeoTIFF", "gdal_translate"},
      {"big.tif", "II+\0\x08\0\0\0"s, "BigTIFF", "gdal_translate"},
      {"renamed.png", "II*\0\x08\0\0\0"s, "GeoTIFF", "gdal_translate"},
      {"dem.asc", "ncols 16\r\nnrows 16\r\nxllcorner 5\r\n", "ESRI ASCII", "gdal_translate"},
      {"grid.txt", "\xef\xbb\xbf  NCOLS 16\nNROWS 16\n", "ESRI ASCII", "gdal_translate"},
      {"dem.r16", "\1\2\3\4", "raw 16-bit", "magick"},
      {"DEM.RAW", "\1\2\3\4", "raw", "magick"},
      {"no_ending", std::string(2 * 16 * 16, '\7'), "raw 16-bit", "magick"},
      {"N46E007.hgt", std::string(2 * 16 * 16, '\7'), "SRTM", "gdal_translate"},
      {"dem.exr", "\x76\x2f\x31\x01\2\0\0\0"s, "OpenEXR", "gdal_translate"},
      {"dem.npy", "\x93NUMPY\1\0"s, "NumPy", "numpy.load"},
      {"dem.nc", "CDF\1\0\0\0\0"s, "netCDF", "gdal_translate"},
      {"dem.h5", "\x89HDF\r\n\x1a\n", "HDF5", "gdal_translate"},
      {"dem.grd", "DSAA\n16 16\n", "Surfer", "gdal_translate"},
      {"photo.jpg", "\xff\xd8\xff\xe0\0\x10JFIF"s, "JPEG", "magick"},
      {"photo.png", "\xff\xd8\xff\xe0\0\x10JFIF"s, "JPEG", "magick"},
      {"p.bmp", "BM\x36\0\0\0"s, "BMP", "magick"},
      {"p.gif", "GIF89a", "GIF", "magick"},
      {"p.webp", "RIFF\1\2\3\4WEBPVP8 ", "WebP", "magick"},
      {"p.pgm", "P5\n16 16\n65535\n", "PGM", "magick"},
      {"p.png.gz", "\x1f\x8b\x08\0"s, "gzip", "unpack"},
      {"p.zip", "PK\3\4\n\0", "ZIP", "unpack"},
      {"saved.png", "<!DOCTYPE html>\n<html>", "web page", "fetch"},
      {"p.png", "version https://git-lfs.github.com/spec/v1\noid", "Git LFS", "git lfs pull"},
      {"p.png", "", "empty", "fetch"}};
  return files;
}

TEST(FileKind, WhatIsNoPngIsCalledByItsNameWithWhatConvertsIt) {
  const TemporaryFolder folder;
  for (const Given& given : given_files()) {
    write_bytes(folder / given.name, given.bytes);
    const std::string said = message([&] { read_height_picture(folder / given.name); });
    EXPECT_NE(said.find("this is no PNG but "), std::string::npos) << given.name << ": " << said;
    EXPECT_NE(said.find(given.told), std::string::npos) << given.name << ": " << said;
    EXPECT_NE(said.find(given.way), std::string::npos) << given.name << ": " << said;
    EXPECT_EQ(said.find("damaged"), std::string::npos) << given.name << ": " << said;
  }
}

TEST(FileKind, APngAndWhatNobodyKnowsAreLeftToTheDecoder) {
  const TemporaryFolder folder;
  write_bytes(folder / "p.tif", "\x89PNG\r\n\x1a\n");
  EXPECT_FALSE(file_kind(folder / "p.tif").has_value()) << "whatever it is called";
  write_bytes(folder / "notes.txt", "some words");
  EXPECT_FALSE(file_kind(folder / "notes.txt").has_value());
  EXPECT_EQ(message([&] { read_height_picture(folder / "notes.txt"); }),
            (folder / "notes.txt").string() + ": this is no PNG; give an 8- or 16-bit grey PNG");
}

}  // namespace
}  // namespace erg
