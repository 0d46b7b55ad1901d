#include "io/run_numbers.h"

#include "analysis/morphometry.h"
#include "analysis/spectrum.h"
#include "wind/shadow.h"

namespace erg {

const std::vector<RunNumber>& run_numbers() {
  static const std::vector<RunNumber> numbers{
      {"step", "Step", "", "Steps done."},
      {"wind_bearing", "Wind from", "deg", "Bearing of the last step's wind."},
      {"wind_strength", "Wind strength", "", "Strength of the last step's wind, as the model understands it."},
      {"max_slabs", "Thickest", "slabs", "Thickest column of the mobile layer."},
      {"mean_slabs", "Mean thickness", "slabs", "Mean thickness of the mobile layer."},
      {"sd_slabs", "Spread of thickness", "slabs", "Standard deviation of the thickness over all cells."},
      {"bare_fraction", "Bare ground", "", "Share of cells without a slab."},
      {"shadow_fraction", "In shadow", "", "Share of cells in the wind's shadow."},
      {"wavelength", "Spacing", "cells", "Mean wavelength of the surface's spectrum."},
      {"crest_bearing", "Crests run", "deg", "Axis along which crests run, clockwise from north."},
      {"mass_now", "Slabs", "slabs", "Slabs on the grid, counted."},
      {"mass_in", "Slabs in", "slabs", "Slabs that entered since the start."},
      {"mass_out", "Slabs out", "slabs", "Slabs that left since the start."},
      {"lifts", "Lifted", "slabs", "Slabs lifted since the row before."},
      {"polls", "Polled", "cells", "Cells polled since the row before."},
      {"flux", "Flux", "slabs/step",
       "Slabs a step that pass one cell of a line across the wind, since the row before."}};
  return numbers;
}

std::vector<double> RunMeter::take(Simulation& simulation) {
  const Terrain& terrain = simulation.terrain();
  const WindNow wind = simulation.last_wind();
  const Morphometry shape = measure(terrain);
  const double fall = simulation.model().shadow_fall(terrain.cell_size());
  const SpectrumNumbers spectrum = measure_spectrum(coarse_surface(terrain, Layer::surface));
  const StepReport& totals = simulation.totals();
  const auto cell_steps =
      static_cast<double>(terrain.extent().cells()) * static_cast<double>(simulation.step_count() - last_step_);
  std::vector<double> row{static_cast<double>(simulation.step_count()),
                          wind.bearing,
                          wind.strength,
                          static_cast<double>(shape.max_slabs),
                          shape.mean_slabs,
                          shape.sd_slabs,
                          shape.bare_fraction,
                          shadow_fraction(shadow_map(terrain, wind.bearing, fall)),
                          spectrum.wavelength,
                          spectrum.crest_bearing,
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

}  // namespace erg
