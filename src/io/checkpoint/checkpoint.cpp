#include "io/checkpoint/checkpoint.h"

#include <zlib.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string>
#include <type_traits>
#include <vector>

#include "core/errors.h"
#include "io/config/config_file.h"
#include "io/files/atomic_file.h"
#include "io/files/given_file.h"
#include "sim/memory.h"
#include "sim/run_check.h"

// The file: 8 magic bytes, the format's version (4 bytes), the payload, and the CRC-32 of everything before it (4
// bytes). Numbers are little-endian; a text or an array is preceded by its length (8 bytes). Payload: config, step,
// totals, account, extent, cell size, quantum, boundary, inflow, bedrock, mobile layer, fields.

namespace erg::io {

using models::StepReport;
using sim::Config;

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

constexpr std::array<char, 8> magic = {'E', 'R', 'G', 'S', 'A', 'V', 'E', '\n'};
constexpr std::size_t piece_bytes = std::size_t{1} << 20;
constexpr std::uint64_t most_fields = 1000;
constexpr double thinnest_slab = 1e-9;  // m: finer than any grain, thicker than any dune is high
constexpr double thickest_slab = 1e6;

class Crc {
 public:
  void add(std::string_view bytes) {
    while (!bytes.empty()) {
      const std::string_view piece = bytes.substr(0, piece_bytes);
      value_ = crc32(value_, reinterpret_cast<const Bytef*>(piece.data()), static_cast<uInt>(piece.size()));
      bytes.remove_prefix(piece.size());
    }
  }
  std::uint32_t value() const { return static_cast<std::uint32_t>(value_); }

 private:
  uLong value_ = crc32(0, nullptr, 0);
};

class Writer {
 public:
  explicit Writer(const ByteSink& sink) : sink_(sink) {}

  void bytes(std::string_view content) {
    crc_.add(content);
    sink_(content);
  }
  template <typename T>
  void number(T value) {
    static_assert(std::is_arithmetic_v<T>);
    bytes({reinterpret_cast<const char*>(&value), sizeof value});
  }
  void text(std::string_view content) {
    number<std::uint64_t>(content.size());
    bytes(content);
  }
  template <typename T>
  void array(std::span<const T> values) {
    number<std::uint64_t>(values.size());
    bytes({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
  }
  void checksum() { number(crc_.value()); }

 private:
  const ByteSink& sink_;
  Crc crc_;
};

void write_totals(Writer& out, const StepReport& totals) {
  out.number(totals.polls);
  out.number(totals.lifts);
  out.number(totals.travel);
  out.number(totals.slabs_in);
  out.number(totals.slabs_out);
  out.number<std::uint8_t>(totals.finished ? 1 : 0);
  out.text(totals.why_finished);
}

void write_terrain(Writer& out, const Terrain& terrain) {
  out.number(terrain.ledger().start);
  out.number(terrain.ledger().in);
  out.number(terrain.ledger().out);
  out.number<std::int32_t>(terrain.nx());
  out.number<std::int32_t>(terrain.ny());
  out.number(terrain.cell_size());
  out.number(terrain.quantum());
  out.number<std::uint8_t>(terrain.boundary() == Boundary::open ? 1 : 0);
  out.number(terrain.inflow());
  out.array(terrain.bedrock().cells());
  out.array(terrain.mobile().cells());
  out.number<std::uint64_t>(terrain.fields().size());
  for (const Field& field : terrain.fields()) {
    for (const std::string* text :
         {&field.info.key, &field.info.label, &field.info.unit, &field.info.palette, &field.info.meaning}) {
      out.text(*text);
    }
    out.number(field.info.minimum);
    out.number(field.info.maximum);
    out.array(field.values.cells());
  }
}

// Reads a file whose checksum has been verified. Still every length is held against what is left of the file before
// anything is allocated: a checksum is no proof of who wrote it.
class CheckpointReader {
 public:
  explicit CheckpointReader(const std::filesystem::path& path) : path_(path), file_(path, std::ios::binary) {
    if (const auto trouble = file_trouble(path, "checkpoint")) throw InputError({*trouble});
    if (!file_) refuse("the checkpoint cannot be opened", "check the name and the permissions");
    file_.seekg(0, std::ios::end);
    left_ = static_cast<std::uint64_t>(file_.tellg());
    file_.seekg(0);
  }

  [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const {
    throw InputError(path_.string(), problem, remedy);
  }
  [[noreturn]] void refuse_damaged(const std::string& what) const {
    refuse("the checkpoint is damaged: " + what, "resume from another checkpoint");
  }

  void check_whole();

  template <typename T>
  T number() {
    T value{};
    bytes(&value, sizeof value);
    return value;
  }
  double finite() {
    const double value = number<double>();
    if (!std::isfinite(value)) refuse_damaged("a number is not finite");
    return value;
  }
  /// Of things that have been counted.
  std::int64_t count() {
    const auto value = number<std::int64_t>();
    if (value < 0 || value > sim::largest_count) refuse_damaged("a count is out of range");
    return value;
  }
  /// A value that a parameter has, too.
  double value_of(const Parameter& parameter) {
    const double value = finite();
    if (check_value(parameter, value, "")) refuse_damaged(parameter.key + " is out of range");
    return value;
  }
  std::string text() {
    std::string content(length(1), '\0');
    bytes(content.data(), content.size());
    return content;
  }
  template <typename T>
  Grid<T> grid(Extent extent) {
    if (length(sizeof(T)) != extent.cells()) refuse_damaged("a layer has not the extent of the grid");
    Grid<T> values(extent);
    bytes(values.cells().data(), values.cells().size_bytes());
    return values;
  }
  std::uint64_t left() const { return left_; }

 private:
  std::size_t length(std::size_t item_bytes) {
    const auto count = number<std::uint64_t>();
    if (count > left_ / item_bytes) refuse_damaged("a length is larger than the file");
    return count;
  }
  void bytes(void* to, std::size_t count) {
    if (count > left_) refuse_damaged("it ends too early");
    file_.read(static_cast<char*>(to), static_cast<std::streamsize>(count));
    if (!file_) refuse("the checkpoint cannot be read to its end", "check the disk");
    left_ -= count;
  }

  std::filesystem::path path_;
  std::ifstream file_;
  std::uint64_t left_ = 0;
};

// Magic, version and checksum; leaves the reader at the payload, with the checksum no longer counted as left.
void CheckpointReader::check_whole() {
  std::array<char, 8> start{};
  if (left_ < magic.size() + 2 * sizeof(std::uint32_t)) refuse("this is no checkpoint", "give a file that erg saved");
  bytes(start.data(), start.size());
  if (start != magic) refuse("this is no checkpoint", "give a file that erg saved");
  const auto version = number<std::uint32_t>();
  if (version != checkpoint_version) {
    refuse("the checkpoint has format " + std::to_string(version) + "; this program reads format " +
               std::to_string(checkpoint_version),
           version > checkpoint_version ? "use a newer erg" : "use the erg that wrote it");
  }
  const std::uint64_t payload = left_ - sizeof(std::uint32_t);
  const std::streampos payload_start = file_.tellg();
  Crc crc;
  crc.add({magic.data(), magic.size()});
  crc.add({reinterpret_cast<const char*>(&version), sizeof version});
  std::string piece;
  while (left_ > sizeof(std::uint32_t)) {
    piece.resize(std::min<std::uint64_t>(piece_bytes, left_ - sizeof(std::uint32_t)));
    bytes(piece.data(), piece.size());
    crc.add(piece);
  }
  if (number<std::uint32_t>() != crc.value()) refuse_damaged("its checksum does not fit");
  file_.seekg(payload_start);
  left_ = payload;
}

StepReport read_totals(CheckpointReader& in) {
  StepReport totals;
  totals.polls = in.count();
  totals.lifts = in.count();
  totals.travel = in.finite();
  totals.slabs_in = in.count();
  totals.slabs_out = in.count();
  totals.finished = in.number<std::uint8_t>() != 0;
  totals.why_finished = in.text();
  return totals;
}

Field read_field(CheckpointReader& in, Extent extent) {
  Field field;
  for (std::string* text :
       {&field.info.key, &field.info.label, &field.info.unit, &field.info.palette, &field.info.meaning}) {
    *text = in.text();
  }
  field.info.minimum = in.finite();
  field.info.maximum = in.finite();
  field.values = in.grid<float>(extent);
  return field;
}

Terrain read_terrain(CheckpointReader& in, const Config& config) {
  MassLedger ledger;
  ledger.start = in.count();
  ledger.in = in.count();
  ledger.out = in.count();
  const auto nx = in.number<std::int32_t>();
  const auto ny = in.number<std::int32_t>();
  if (nx != config.grid.integer("nx") || ny != config.grid.integer("ny")) {
    in.refuse_damaged("grid and config differ in extent");
  }
  const double cell_size = in.value_of(*config.grid.find("cell_size"));
  const double quantum = in.finite();
  if (quantum < thinnest_slab || quantum > thickest_slab) in.refuse_damaged("the height of a slab is out of range");
  const bool open = in.number<std::uint8_t>() != 0;
  const double inflow = in.value_of(*config.grid.find("inflow"));
  const Extent extent{nx, ny};
  if (in.left() / (2 * sizeof(std::int32_t)) < extent.cells()) in.refuse_damaged("it ends too early");
  Terrain terrain(extent, cell_size, quantum, open ? Boundary::open : Boundary::torus);
  terrain.set_inflow(inflow);
  terrain.edit_bedrock() = in.grid<std::int32_t>(terrain.extent());
  terrain.edit_mobile() = in.grid<std::int32_t>(terrain.extent());
  const auto fields = in.number<std::uint64_t>();
  if (fields > most_fields) in.refuse_damaged("it has too many fields");
  for (std::uint64_t field = 0; field < fields; ++field) {
    terrain.edit_fields().push_back(read_field(in, terrain.extent()));
  }
  terrain.ledger() = ledger;
  return terrain;
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const Config& config, const sim::RunState& state) {
  check_whole(state.terrain);
  write_file_atomically(path, [&](const ByteSink& sink) {
    Writer out(sink);
    out.bytes({magic.data(), magic.size()});
    out.number(checkpoint_version);
    out.text(config_text(config));
    out.number(state.step);
    write_totals(out, state.totals);
    write_terrain(out, state.terrain);
    out.checksum();
  });
}

Saved read_checkpoint(const std::filesystem::path& path) {
  CheckpointReader in(path);
  in.check_whole();
  Saved saved{parse_config(in.text(), path.string() + " (its config)"), {}};
  saved.state.step = in.count();
  saved.state.totals = read_totals(in);
  sim::check_memory({&saved.config, 1}, 0, sim::free_memory());
  saved.state.terrain = read_terrain(in, saved.config);
  if (in.left() != 0) in.refuse_damaged("something follows its end");
  const Terrain& terrain = saved.state.terrain;
  if (const auto problem = sim::terrain_problem(saved.config, terrain.quantum(), terrain)) in.refuse_damaged(*problem);
  if (const auto problem = sim::ledger_problem(terrain)) in.refuse_damaged(*problem);
  return saved;
}

}  // namespace erg::io
