// The shape of barchans: height to width, horns, slip faces, of a lone one and of those of a field.
#include "analysis/dune_outlines.h"
#include "app/validate/validation_nature.h"

namespace erg::app {

using analysis::Dune;
using sim::Simulation;

namespace {

constexpr double natural_width = 10;  // in heights
constexpr double width_bound = 3;
constexpr double natural_slip_face = 33;  // degrees
constexpr double slip_face_bound = 3;
constexpr double horns_bound = 1.6;  // the longer over the shorter

/// Sums over the dunes of a terrain, each counted by its cells.
struct BarchanMeans {
  double dunes = 0;
  double width = 0;   ///< in heights
  double horned = 0;  ///< share of the dunes' cells that belong to dunes with two horns
  double left = 0;    ///< horns over width
  double right = 0;
  double arms = 0;
  double slip_face = 0;  ///< degrees
};

BarchanMeans means_of(const std::vector<Dune>& dunes) {
  BarchanMeans means;
  double cells = 0;
  double horned = 0;
  double slipping = 0;
  for (const Dune& dune : dunes) {
    const auto weight = static_cast<double>(dune.cells);
    cells += weight;
    means.width += weight * dune.width / dune.height;
    means.arms += weight * dune.arms;
    if (dune.horns) {
      horned += weight;
      means.left += weight * dune.horns->left / dune.width;
      means.right += weight * dune.horns->right / dune.width;
    }
    if (dune.slip_face) {
      slipping += weight;
      means.slip_face += weight * *dune.slip_face;
    }
  }
  means.dunes = static_cast<double>(dunes.size());
  if (cells > 0) means.width /= cells;
  if (cells > 0) means.arms /= cells;
  if (cells > 0) means.horned = horned / cells;
  if (horned > 0) means.left /= horned;
  if (horned > 0) means.right /= horned;
  if (slipping > 0) means.slip_face /= slipping;
  return means;
}

struct BarchanScene {
  const char* name;
  const char* model;
  int cone;  ///< slabs; 0: a field that grows from 3 slabs a cell
  int steps;
};

BarchanMeans barchan_run(const BarchanScene& scene, int seed) {
  const std::string seeded = "run.seed=" + std::to_string(seed);
  Simulation simulation =
      scene.cone > 0 ? lone_cones(nature_config(scene.model, {"grid.nx=320", "grid.ny=160", "scene.sand=0", seeded}),
                                  {{80, 80, scene.cone}})
                     : Simulation(nature_config(scene.model, {"grid.nx=256", "grid.ny=256", "scene.sand=3", seeded}));
  while (simulation.step_count() < scene.steps) simulation.step();
  return means_of(analysis::find_dunes(simulation.terrain(), 270).dunes);
}

}  // namespace

std::string barchan_shape(const ValidationOptions& options) {
  const std::vector<BarchanScene> scenes{
      {"Werner, a lone dune", "werner", 60, 400}, {"Werner, a field", "werner", 0, 1000},
      {"Momiji, a lone dune", "momiji", 60, 400}, {"Momiji, a field", "momiji", 0, 1000},
      {"Bishop, a lone dune", "bishop", 60, 400}, {"Bishop, a field", "bishop", 0, 1000}};
  const int seeds = options.quick ? 1 : 3;
  const int jobs = static_cast<int>(scenes.size()) * seeds;
  say_measuring("barchans", jobs);
  const std::vector<BarchanMeans> all = side_by_side<BarchanMeans>(
      jobs, [&](int job) { return barchan_run(scenes[static_cast<std::size_t>(job / seeds)], 1 + job % seeds); });
  TextTable table;
  table.heading = {"scene", "dunes",      "width / height", "about 10",  "horned",  "left",
                   "right", "like horns", "arms",           "slip face", "about 33"};
  auto next = all.begin();
  for (const BarchanScene& scene : scenes) {
    const std::vector<BarchanMeans> runs(next, next + seeds);
    next += seeds;
    const auto sample = [&](double BarchanMeans::*number) {
      Sample values;
      for (const BarchanMeans& run : runs) values.add(run.*number);
      return values;
    };
    const Sample width = sample(&BarchanMeans::width);
    const Sample slip = sample(&BarchanMeans::slip_face);
    const double left = sample(&BarchanMeans::left).mean();
    const double right = sample(&BarchanMeans::right).mean();
    const bool horns = left > 0 && right > 0;
    table.rows.push_back({scene.name, sample(&BarchanMeans::dunes).text(1), width.text(1),
                          verdict(width.mean() - natural_width, width_bound), sample(&BarchanMeans::horned).text(2),
                          sample(&BarchanMeans::left).text(2), sample(&BarchanMeans::right).text(2),
                          horns ? verdict(std::abs(std::log(left / right)), std::log(horns_bound)) : "no horns",
                          sample(&BarchanMeans::arms).text(2), slip.text(1),
                          verdict(slip.mean() - natural_slip_face, slip_face_bound)});
  }
  return "### Barchans\n\nBarchans are about ten times as wide as high, their horns point downwind and are about alike "
         "under one wind, and their slip faces stand at about 33 degrees (Bagnold 1941; Hesp & Hastings 1998). A lone "
         "dune: a cone of 60 slabs on bare ground, 320 x 160 cells, after 400 steps; a field: 3 slabs a cell, 256 x "
         "256 "
         "cells, after 1000 steps; outlines and horns by the rules of `erg measure`, mean over " +
         count_text(seeds, "seed") + ", each dune counted by its cells. width / height *holds* within " +
         fixed_text(width_bound, 0) +
         " of 10; horned: share of the dunes (by cells) with two horns; left, right: their lengths over the dune's "
         "width, "
         "*hold* where the longer is at most " +
         fixed_text(horns_bound, 1) +
         " times the shorter; arms: positive where the sides lie downwind; slip face: degrees, *holds* within " +
         fixed_text(slip_face_bound, 0) + ".\n\n" + table.markdown();
}

}  // namespace erg::app
