// Laws of nature that the models are held against, one or a family in each file validation_nature_*.cpp. Each measures
// over several seeds and writes its table: what nature has beside what came out, and whether that holds.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "app/cli/text_table.h"
#include "app/validate/sample.h"
#include "app/validate/validation.h"

namespace erg::app {

/// Crests under two winds: Rubin & Hunter 1987; Courrech du Pont et al. 2014 and Gao et al. 2015.
std::string crests_under_two_winds(const ValidationOptions& options);
/// Dunes move the more slowly the higher they are: Bagnold 1941.
std::string speed_against_height(const ValidationOptions& options);
/// Barchans: height to width, horns, slip faces.
std::string barchan_shape(const ValidationOptions& options);
/// A small barchan that comes upon a larger one.
std::string barchan_collision(const ValidationOptions& options);
/// As many arms as winds: Zhang et al. 2012.
std::string star_dune_arms(const ValidationOptions& options);
/// Spacing, height and defects of crests over time.
std::string growth_of_crests(const ValidationOptions& options);
/// Ripples from young beds: Bagnold 1941, Andreotti et al. 2006.
std::string ripples_against_wind(const ValidationOptions& options);
/// Mounds of snow that bonds, beside the same without bonding: Sharma et al. 2019.
std::string sintering_slows_mounds(const ValidationOptions& options);
/// Arms of parabolic dunes and tails of nebkhas, beside the same terrain without plants.
std::string plants_make_shapes(const ValidationOptions& options);

/// A law's word: "holds" when `error` is at most `bound`, "partly" up to twice that, else "**fails**".
std::string verdict(double error, double bound);

/// The exponent n of y ~ x^n: slope of the least-squares line through the logarithms of `x` and `y`, both positive.
double power_law(const std::vector<double>& x, const std::vector<double>& y);

/// A config of `model` with these settings, for `cpu` on one thread.
sim::Config nature_config(const std::string& model, const std::vector<std::string>& settings);

/// A heap of sand on bare ground: its middle (cells) and height (slabs of a third of a cell).
struct Cone {
  int x;
  int y;
  int height;
};
/// How wide such a heap is, cells for each slab of height: three times as wide as high, at just under its repose.
inline constexpr double cells_wide_a_slab = 1;

/// A run of `config`, whose scene has no sand, that begins with these heaps as cones.
sim::Simulation lone_cones(const sim::Config& config, const std::vector<Cone>& cones);

/// Says on standard error what is measured now.
void say_measuring(const std::string& law, int runs);

}  // namespace erg::app
