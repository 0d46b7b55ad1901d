// The figures of docs/validation.md: what this program gives beside what is in print, and its two executors beside each
// other.
#pragma once

#include <string>
#include <vector>

namespace erg::app {

/// What `erg validate` was asked for.
struct ValidationOptions {
  bool quick = false;  ///< fewer seeds, fewer steps, only the small scenes
  std::string scene;   ///< of the published scenes only this preset of cfg/thesis/; empty: all of them
  std::string law;     ///< of the laws of nature only this one; empty: all of them
};

/// Each measures (and says on standard error what it is at) and returns a section of Markdown.
/// Published maxima of the presets in cfg/thesis/, on `serial` and `cpu`.
std::string published_section(const ValidationOptions& options);
/// The presets of which it has a row.
std::vector<std::string> published_presets();
/// `serial` and `cpu`: the statistics of the same scenes over several seeds.
std::string executors_section(const ValidationOptions& options);
/// Dunes under winds from several bearings, with and without a spread: one barchan, crests under two winds, fields.
std::string bearings_section(const ValidationOptions& options);
/// Which forms sintering snow takes, by wind and calm hours.
std::string snow_section(const ValidationOptions& options);
/// Shapes of dunes among plants, beside the same terrain without plants.
std::string plants_section(const ValidationOptions& options);
/// Ripples of the grain model under several winds.
std::string ripples_section(const ValidationOptions& options);
/// Laws of nature, each beside what the models do; of one law only its own part, under a heading of the third level.
std::string nature_section(const ValidationOptions& options);
/// The laws of which it has a table.
std::vector<std::string> nature_law_names();
/// What follows from the rules by algebra.
std::string identities_section();

}  // namespace erg::app
