#include "io/formats/vti.h"

#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "core/number_text.h"
#include "io/files/atomic_file.h"
#include "io/files/raw_bytes.h"

namespace erg::io {
namespace {

// One array of values at the cells' centres, written row by row.
struct PointArray {
  std::string name;
  std::string type;
  std::size_t value_bytes = 4;
  std::function<void(int y, std::string& row)> append_row;
};

PointArray metres_array(std::string name, const Terrain& terrain, std::function<std::int32_t(int, int)> quanta) {
  return {std::move(name), "Float32", 4, [&terrain, quanta = std::move(quanta)](int y, std::string& row) {
            for (int x = 0; x < terrain.nx(); ++x) {
              append_raw(row, static_cast<float>(terrain.metres(quanta(x, y))));
            }
          }};
}

PointArray field_array(const Field& field) {
  return {field.info.key, "Float32", 4, [&field](int y, std::string& row) {
            for (const float value : field.values.row(y)) append_raw(row, value);
          }};
}

std::vector<PointArray> arrays_of(const Terrain& terrain, const Grid<std::uint8_t>* shadow,
                                  std::span<const Field> more) {
  std::vector<PointArray> arrays = {
      metres_array("surface", terrain, [&](int x, int y) { return terrain.height(x, y); }),
      metres_array("sand", terrain, [&](int x, int y) { return terrain.mobile()(x, y); }),
      metres_array("bedrock", terrain, [&](int x, int y) { return terrain.bedrock()(x, y); })};
  if (shadow != nullptr) {
    arrays.push_back({"shadow", "UInt8", 1, [shadow](int y, std::string& row) {
                        for (const std::uint8_t dark : shadow->row(y)) append_raw(row, dark);
                      }});
  }
  for (const Field& field : terrain.fields()) arrays.push_back(field_array(field));
  for (const Field& field : more) arrays.push_back(field_array(field));
  return arrays;
}

// A string as VTK has it in XML: the codes of its bytes, ended by 0.
std::string string_array(const std::string& name, const std::string& text) {
  std::ostringstream out;
  out << "      <Array type=\"String\" Name=\"" << name << "\" NumberOfTuples=\"1\" format=\"ascii\">\n        ";
  for (const char c : text) out << static_cast<int>(static_cast<unsigned char>(c)) << ' ';
  out << "0\n      </Array>\n";
  return out.str();
}

std::string header(const Terrain& terrain, const std::vector<PointArray>& arrays, const Provenance& provenance,
                   const MetadataEntries& source) {
  std::ostringstream out;
  out.precision(17);
  std::ostringstream extent;
  extent << "0 " << terrain.nx() - 1 << " 0 " << terrain.ny() - 1 << " 0 0";
  const double cell = terrain.cell_size();
  out << "<?xml version=\"1.0\"?>\n"
      << "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      << "  <ImageData WholeExtent=\"" << extent.str() << "\" Origin=\"" << cell / 2 << ' ' << cell / 2
      << " 0\" Spacing=\"" << cell << ' ' << cell << ' ' << cell << "\">\n    <FieldData>\n";
  for (const auto& [name, text] : source) out << string_array(name, text);
  out << "      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">"
      << format_shortest(std::isfinite(provenance.days) ? provenance.days : static_cast<double>(provenance.step))
      << "</DataArray>\n";
  out << "    </FieldData>\n    <Piece Extent=\"" << extent.str() << "\">\n      <PointData Scalars=\"surface\">\n";
  std::uint64_t offset = 0;
  for (const PointArray& array : arrays) {
    out << "        <DataArray type=\"" << array.type << "\" Name=\"" << array.name
        << "\" format=\"appended\" offset=\"" << offset << "\"/>\n";
    offset += sizeof(std::uint64_t) + terrain.extent().cells() * array.value_bytes;
  }
  out << "      </PointData>\n      <CellData/>\n    </Piece>\n  </ImageData>\n"
      << "  <AppendedData encoding=\"raw\">\n   _";
  return out.str();
}

}  // namespace

void write_vti(const std::filesystem::path& path, const Terrain& terrain, const Grid<std::uint8_t>* shadow,
               const Provenance& provenance, std::span<const Field> more) {
  check_whole(terrain);
  const std::vector<PointArray> arrays = arrays_of(terrain, shadow, more);
  const MetadataEntries source = metadata_of_file(path, provenance);
  write_file_atomically(path, [&](const ByteSink& sink) {
    sink(header(terrain, arrays, provenance, source));
    std::string row;
    for (const PointArray& array : arrays) {
      row.clear();
      append_raw(row, std::uint64_t{terrain.extent().cells() * array.value_bytes});
      for (int y = 0; y < terrain.ny(); ++y) {
        array.append_row(y, row);
        sink(row);
        row.clear();
      }
    }
    sink("\n  </AppendedData>\n</VTKFile>\n");
  });
}

}  // namespace erg::io
