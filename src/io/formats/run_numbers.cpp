#include "io/formats/run_numbers.h"

#include <algorithm>
#include <limits>

#include "analysis/crests.h"
#include "analysis/morphometry.h"
#include "analysis/spectrum.h"
#include "core/number_text.h"
#include "kernels/shadow.h"
#include "sim/step_time.h"

namespace erg::io {

using analysis::coarse_surface;
using analysis::Layer;
using analysis::Shift;
using sim::Simulation;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr int most_blocks = 256;  // a side

}  // namespace

const std::vector<RunNumber>& run_numbers() {
  static const std::vector<RunNumber> numbers{
      {"step", "Step", "", "Steps done."},
      {"days", "Time", "days", "Time since the start, by what a step of the model stands for."},
      {"wind_bearing", "Wind from", "deg", "Bearing of the last step's wind."},
      {"wind_strength", "Wind strength", "", "Strength of the last step's wind, as the model understands it."},
      {"max_slabs", "Thickest", "slabs", "Thickest column of the mobile layer."},
      {"mean_slabs", "Mean thickness", "slabs", "Mean thickness of the mobile layer."},
      {"sd_slabs", "Spread of thickness", "slabs", "Standard deviation of the thickness over all cells."},
      {"bare_fraction", "Bare ground", "", "Share of cells without a slab."},
      {"shadow_fraction", "In shadow", "", "Share of cells in the wind's shadow."},
      {"wavelength", "Wavelength", "cells", "Mean wavelength of the surface's spectrum, in which rubble counts too."},
      {"crest_spacing", "Spacing of crests", "cells", "Mean distance from crest to crest along the wind, counted."},
      {"crest_bearing", "Crests run", "deg",
       "Axis along which crests run, clockwise from north; none where their alignment is below " +
           format_shortest(analysis::least_alignment) + "."},
      {"alignment", "Alignment", "", "How far all crests run one way: 1 all, 0 none."},
      {"migration_x", "Migration eastward", "cells/step", "Motion of the pattern over the last steps."},
      {"migration_y", "Migration northward", "cells/step", "Motion of the pattern over the last steps."},
      {"mass_now", "Slabs", "slabs", "Slabs on the grid, counted."},
      {"mass_in", "Slabs in", "slabs", "Slabs that entered since the start."},
      {"mass_out", "Slabs out", "slabs", "Slabs that left since the start."},
      {"lifts", "Lifted", "slabs", "Slabs lifted since the row before."},
      {"polls", "Polled", "cells", "Cells polled since the row before."},
      {"flux", "Flux", "slabs/step",
       "Slabs a step that pass one cell of a line across the wind, since the row before."}};
  return numbers;
}

void RunMeter::look(Simulation& simulation) {
  const Terrain& terrain = simulation.terrain();
  // Where whole dunes stand shows on coarse ground too, which is cheaper.
  migration_.observe(simulation.step_count(), coarse_surface(terrain, Layer::surface, most_blocks),
                     simulation.share_work());
  last_look_ = simulation.step_count();
}

void RunMeter::glance(Simulation& simulation) {
  migration_.restart();
  look(simulation);
}

std::vector<double> RunMeter::take(Simulation& simulation) {
  if (simulation.step_count() - last_look_ > longest_look) migration_.restart();
  look(simulation);
  const Shift migration = migration_.velocity().value_or(Shift{unknown, unknown});
  migration_.start_anew();
  const Terrain& terrain = simulation.terrain();
  const forcing::Forcing wind = simulation.last_wind();
  const analysis::Morphometry shape = analysis::measure(terrain);
  const double fall = simulation.model().shadow_fall(terrain.cell_size());
  const analysis::CoarseSurface surface = coarse_surface(terrain, Layer::surface);
  const ShareWork share = simulation.share_work();
  const analysis::SpectrumNumbers spectrum = analysis::measure_spectrum(surface, share);
  const models::StepReport& totals = simulation.totals();
  const auto cell_steps =
      static_cast<double>(terrain.extent().cells()) * static_cast<double>(simulation.step_count() - last_step_);
  std::vector<double> row{static_cast<double>(simulation.step_count()),
                          sim::days_after(simulation.config(), simulation.step_count()),
                          wind.bearing,
                          wind.strength,
                          static_cast<double>(shape.max_slabs),
                          shape.mean_slabs,
                          shape.sd_slabs,
                          shape.bare_fraction,
                          analysis::shadow_fraction(kernels::shadow_map(terrain, wind.bearing, fall)),
                          spectrum.wavelength,
                          analysis::crest_spacing(surface, wind.mean_bearing(), share),
                          spectrum.crest_bearing.value_or(unknown),
                          spectrum.alignment,
                          migration.x,
                          migration.y,
                          static_cast<double>(terrain.total_mobile()),
                          static_cast<double>(terrain.ledger().in),
                          static_cast<double>(terrain.ledger().out),
                          static_cast<double>(totals.lifts - last_totals_.lifts),
                          static_cast<double>(totals.polls - last_totals_.polls),
                          cell_steps > 0 ? (totals.travel - last_totals_.travel) / cell_steps : 0};
  last_totals_ = totals;
  last_step_ = simulation.step_count();
  return row;
}

}  // namespace erg::io
