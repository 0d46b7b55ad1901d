// What is being set up: a config under edit, in which nothing invalid can be entered.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/errors.h"
#include "core/parameters.h"
#include "models/model.h"
#include "session/wind_editor.h"
#include "sim/config.h"

namespace erg::session {

/// One value as a panel shows it, with its declaration.
struct SetupRow {
  std::string group;                     ///< "grid", "scene", "parameters", "run"
  const Parameter* parameter = nullptr;  ///< key, label, unit, range, meaning, source; lives as long as the setup
  ParameterValue value;
  bool changed = false;            ///< not at its default
  bool relevant = true;            ///< false: has no effect with the other values as they are (active_if)
  bool needs_new_terrain = false;  ///< a change takes effect with CREATE only
  bool pending = false;            ///< differs from what runs now

  /// The tooltip: meaning, unit, what is accepted, default, source, when it takes effect.
  std::string tooltip() const;
};

/// A config under edit.
class Setup {
 public:
  /// Everything at its default.
  Setup() = default;
  explicit Setup(sim::Config config) { replace(std::move(config)); }

  const sim::Config& config() const { return config_; }
  /// Another config in place of this one, as after loading.
  void replace(sim::Config config) {
    config_ = std::move(config);
    named_ = {config_.model, config_.title, config_.description};
  }

  /// The models that move this material, in the catalogue's order.
  static std::vector<const models::ModelType*> models_of(Material material);
  Material material() const;
  /// Changes to the first model of the material, unless it is that material already.
  void choose_material(Material material);
  const models::ModelType& model() const;
  /// A title and a description speak of the model that they were given for: under another one there are none, until it
  /// is chosen again. Throws InputError for an unknown key.
  void choose_model(const std::string& key);

  /// The rows of one group, in the order of the declarations. `running`: the config of the run now, or null.
  std::vector<SetupRow> rows(const std::string& group, const sim::Config* running = nullptr) const;
  /// Enters a value; what is wrong with it, and then nothing has changed.
  std::optional<Mistake> set(const std::string& group, const std::string& key, const ParameterValue& value);
  /// The same as typed.
  std::optional<Mistake> set_text(const std::string& group, const std::string& key, std::string_view text);
  /// One value back to its default.
  void reset(const std::string& group, const std::string& key);
  /// RESET DEFAULT: everything but the model, the wind included.
  void reset_all();

  void set_title(std::string title) {
    config_.title = std::move(title);
    named_ = {config_.model, config_.title, config_.description};
  }
  /// Whether the model is the one that title and file were given for.
  bool has_its_own_model() const { return config_.model == named_.model; }

  /// The wind under edit.
  WindEditor wind() { return WindEditor(config_.wind, sim::starting_wind(model().info.start)); }

  /// A channel's course over the `run.steps` steps of the run. Says what is wrong, and then nothing has changed.
  std::optional<Mistake> set_course(const forcing::Channel& channel, const forcing::Course& course);

  /// Whether CREATE draws a new seed each time.
  bool fresh_seed() const { return fresh_seed_; }
  void set_fresh_seed(bool fresh) { fresh_seed_ = fresh; }

  /// What the values mean on the grid, in words of the model ("repose 33.7°: a step of 3 slabs stands").
  std::vector<std::string> explanations() const;
  /// What stands against CREATE: pictures that are missing. Each value by itself is always right.
  std::vector<Mistake> mistakes() const;
  /// Whether CREATE is needed for what differs from the running config.
  bool needs_new_terrain(const sim::Config& running) const;
  /// The running config with what may take effect without a new terrain: the wind, and every value that is not read at
  /// the start only. The running config itself where the model is another one.
  sim::Config in_force_on(const sim::Config& running) const;
  /// The config that CREATE makes: with the grid of the picture, and with a new seed if fresh_seed, both kept from then
  /// on. Throws InputError with mistakes(), and where that picture cannot be read.
  sim::Config config_to_create();

 private:
  ParameterValues* group(const std::string& key);

  /// What a config was called, and the model that was called so.
  struct Named {
    std::string model, title, description;
  };

  sim::Config config_;
  Named named_{config_.model, {}, {}};
  bool fresh_seed_ = false;
};

}  // namespace erg::session
