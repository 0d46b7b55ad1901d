// The ground: bedrock below, a mobile layer of sand or snow on it, both counted in whole quanta.
//
// Heights are integers, so moving material is integer addition: mass is conserved exactly and nothing drifts. Metres
// exist only at the edges (`metres`, export, picture). One quantum is the slab of the slab models.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/grid.h"
#include "core/stamp.h"

namespace erg {

/// What happens at the edges of the grid.
enum class Boundary {
  torus,  ///< what leaves on one side enters on the other
  open    ///< what leaves is counted and gone; inflow enters at the upwind edges
};

/// An extra layer that a model declares: what it is, its unit and range, and the palette that shows it best.
struct FieldInfo {
  std::string key;    ///< name in files and on the command line
  std::string label;  ///< name for people
  std::string unit;   ///< "" for a pure number
  double minimum = 0;
  double maximum = 1;
  std::string palette;
  std::string meaning;
};

/// A declared layer with its values.
struct Field {
  FieldInfo info;
  Grid<float> values;
};

/// The layer with this key; null if there is none.
Field* find_field(std::vector<Field>& fields, std::string_view key);
const Field* find_field(const std::vector<Field>& fields, std::string_view key);

/// Exact account of the mobile material, in quanta: start + in - out = now, always.
struct MassLedger {
  std::int64_t start = 0;
  std::int64_t in = 0;
  std::int64_t out = 0;

  std::int64_t expected() const { return start + in - out; }
  bool operator==(const MassLedger&) const = default;
};

/// Smallest and largest grid side, in cells.
inline constexpr int smallest_side = 1;
inline constexpr int largest_side = 16384;

/// The layers of a terrain, the fields that lie on it, and the account of its mobile material. Row 0 is the
/// southernmost.
class Terrain {
 public:
  Terrain() = default;
  /// A flat, empty terrain. cell_size in m; quantum in m: the height of one count. Throws InputError for sides outside
  /// of smallest_side to largest_side, and for lengths that are not positive.
  Terrain(Extent extent, double cell_size, double quantum, Boundary boundary = Boundary::torus);

  Extent extent() const { return bedrock_.extent(); }
  int nx() const { return bedrock_.nx(); }
  int ny() const { return bedrock_.ny(); }
  double cell_size() const { return cell_size_; }
  double quantum() const { return quantum_; }
  Boundary boundary() const { return boundary_; }
  /// Open boundary: quanta that enter per step and cell of upwind edge.
  double inflow() const { return inflow_; }
  void set_inflow(double inflow) { inflow_ = inflow; }

  /// Height of the immobile ground in quanta; may be negative.
  const Grid<std::int32_t>& bedrock() const { return bedrock_; }
  /// Thickness of the mobile layer in quanta; never negative.
  const Grid<std::int32_t>& mobile() const { return mobile_; }
  /// Surface = bedrock + mobile, in quanta.
  std::int32_t height(int x, int y) const { return bedrock_(x, y) + mobile_(x, y); }
  /// A count of quanta as a height in m.
  double metres(std::int32_t quanta) const { return quantum_ * quanta; }

  /// Writable layers, to be written before the next step. Asking for one renews the stamp: what executors hold of this
  /// terrain is out of date.
  Grid<std::int32_t>& edit_bedrock();
  Grid<std::int32_t>& edit_mobile();
  /// Stands for what bedrock and mobile layer hold now (Stamp): a copy has another.
  std::uint64_t stamp() const { return stamp_.value(); }

  /// The layers that the model declares, in its order.
  const std::vector<Field>& fields() const { return fields_; }
  std::vector<Field>& edit_fields();
  /// Stands for what the fields hold now.
  std::uint64_t fields_stamp() const { return fields_stamp_.value(); }

  MassLedger& ledger() { return ledger_; }
  const MassLedger& ledger() const { return ledger_; }
  /// Quanta on the ground, counted.
  std::int64_t total_mobile() const;
  /// Start the account anew from what lies on the ground now.
  void open_ledger();

 private:
  double cell_size_ = 1.0;
  double quantum_ = 1.0;
  Boundary boundary_ = Boundary::torus;
  double inflow_ = 0;
  Grid<std::int32_t> bedrock_;
  Grid<std::int32_t> mobile_;
  std::vector<Field> fields_;
  MassLedger ledger_;
  Stamp stamp_;
  Stamp fields_stamp_;
};

/// Throws InputError for a terrain without cells, and for one whose two layers differ in extent: it has no surface.
void check_surface(const Terrain& terrain);

/// Throws InputError for a terrain without cells, and for one whose layers and fields differ in extent: nothing can be
/// measured or written of it.
void check_whole(const Terrain& terrain);

/// A hash of everything that decides how the terrain goes on: extent, layers, fields. For golden tests and `--hash`.
/// Throws as check_whole does.
std::uint64_t state_hash(const Terrain& terrain);

}  // namespace erg
