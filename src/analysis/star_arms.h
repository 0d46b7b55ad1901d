// How many arms a star dune has, by its plan form about its middle.
#pragma once

#include <vector>

#include "core/grid.h"
#include "core/terrain.h"

namespace erg::analysis {

/// The arms of one dune.
struct StarArms {
  double x = 0;        ///< the dune's middle, cells: that of its sand above half the height of its top
  double y = 0;        ///< (within the grid)
  double height = 0;   ///< of its top over the lowest ground within reach, in units of the heights given
  int arms = 0;        ///< 2 for a ridge, 3 for a star of three arms ...; 0 where nothing stands out: a dome or a cone
  double depth = 0;    ///< how far they stand out: amplitude of that harmonic over the mean, 0 for a dome
  double bearing = 0;  ///< of one of the arms from the middle, degrees clockwise from north, in [0, 360 / arms)
  /// Amplitudes of all harmonics over the mean: harmonics[k] repeats k times in a turn. 1 says that the dune is longer
  /// to one side, and counts for no arm.
  std::vector<double> harmonics;
};

/// What `count_arms` goes by.
inline constexpr int most_arms = 8;
/// Less is a dome. The corners of a pyramid count as arms: one of 3, 4, 5 or 6 sides has a depth of 0.84, 0.43, 0.26 or
/// 0.18; a star whose sides are hollow has more.
inline constexpr double least_depth = 0.15;

/// The arms of the dune that stands at (x, y) of a torus, as far as `reach` cells from its middle. Over each direction
/// the sand above the lowest ground within reach is summed, counted by the square of its distance (so that arms count,
/// not the core), and the sum over all directions is taken apart into harmonics: the largest of 2 to `most_arms` is the
/// number of arms, if it reaches `least_depth` of the mean.
StarArms count_arms(const Grid<double>& heights, int x, int y, double reach);

/// The dunes of a torus, the highest first: tops of the surface, taken as means over squares of three cells, that stand
/// at least `apart` cells from every higher one and at least half as high as the highest over the lowest ground. Arms
/// are followed for half of `apart`.
std::vector<StarArms> find_stars(const Terrain& terrain, double apart);

}  // namespace erg::analysis
