// Wang & Hu 2012, after Cimbura 2022 and Szabo 2019: single grains that leap, bounce and knock others loose; sand and
// snow ripples.
//
// Physics: a grain leaves loose, unsheltered ground with an upward speed of B u* at 21 to 90 degrees, flies under
// gravity and drag (d v / d t = -g + k |U - v| (U - v), k = 3 C_d rho_air / (4 rho_grain d), sqrt C_d = sqrt C +
// sqrt(24 / Re)) in a log wind U(z) over the local surface, and bounces: the speed across the ground is reversed and
// damped, that along it damped. It stays when slow, in the 15 degree wind shadow, or after a few bounces. Every impact
// knocks grains loose that reptate a few centimetres, in low parabolas.
//
// Both theses' ripples crept upwind and their grains never settled. The cures here: height above the LOCAL ground, no
// wind in the shadow, the wind among flying grains held at the threshold (Bagnold's focus), and splash, without which
// nothing migrates.
//
// Assumes: parcels of grains instead of single ones; a ground frozen during a sub-step. Does not model: turbulence, the
// speed-up of the wind over a hill, time in seconds (a step polls as many grains as the grid has cells), sorting by
// size.
#pragma once

#include <memory>
#include <vector>

#include "forcing/wind_frame.h"
#include "models/grains/grain_solver.h"
#include "models/grains/grain_values.h"
#include "models/model.h"

namespace erg::models {

/// Key of the layer of plants that the model declares; that of bonded grains is `bonded_field`.
inline constexpr const char* plants_field = "vegetation";

/// The model at work.
class GrainModel : public Model {
 public:
  explicit GrainModel(const GrainValues& values);

  double quantum() const override;
  void begin(Terrain& terrain) override;
  StepReport step(Terrain& terrain, const forcing::Forcing& wind, StepKey key, compute::Executor& executor) override;
  double shadow_fall(double cell_size) const override;
  std::vector<Diagnostic> diagnostics() const override;
  void keep_trajectories(int count) override { trajectories_wanted_ = count; }
  std::vector<Trajectory> trajectories() const override { return trajectories_; }

 private:
  std::shared_ptr<const std::vector<float>> shelter(const Terrain& terrain, const forcing::WindFrame& frame,
                                                    double bearing);
  GrainStepLaw step_law(const Terrain& terrain, const forcing::WindFrame& frame, const forcing::Forcing& wind);
  void trace_trajectories(const Terrain& terrain, const forcing::WindFrame& frame, const GrainStepLaw& law, StepKey key,
                          const SurfaceSnapshot& ground);

  GrainValues values_;
  std::shared_ptr<const std::vector<float>> shelter_;
  double shelter_bearing_ = 0;        // of the wind that shelter_ is for
  Grid<float> shelter_plants_;        // of which it was made
  std::uint64_t shelter_fields_ = 0;  // of the terrain's fields when the plants were last looked at
  FlightCounters flights_;
  std::int64_t lifts_ = 0;
  std::int64_t cut_off_ = 0;  // since the run was begun or taken up
  int trajectories_wanted_ = 0;
  std::vector<Trajectory> trajectories_;
};

/// The catalogue entry.
ModelType grains();

}  // namespace erg::models
