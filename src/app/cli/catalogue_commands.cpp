// `erg models` and `erg model NAME`: what the catalogue declares, as text or Markdown.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <span>

#include "app/cli/command.h"
#include "app/cli/text_table.h"
#include "core/join.h"
#include "core/number_text.h"
#include "models/model.h"
#include "sim/step_time.h"

namespace erg::app {

using models::ModelInfo;
using models::ModelType;

namespace {

std::string condition_text(const Parameter& parameter) {
  if (parameter.active_if.size() < 2) return "";
  const std::span<const std::string> condition = parameter.active_if;
  return " Only with " + condition.front() + " " + join(condition.subspan(1), " or ") + ".";
}

TextTable parameter_table(const Parameters& parameters) {
  TextTable table;
  table.heading = {"key", "default", "accepts", "unit", "meaning", "source"};
  for (const Parameter& parameter : parameters) {
    table.rows.push_back({parameter.key, value_text(parameter.default_value), accepted_text(parameter),
                          unit_text(parameter.unit), parameter.meaning + condition_text(parameter), parameter.source});
  }
  return table;
}

TextTable field_table(const std::vector<FieldInfo>& fields) {
  TextTable table;
  table.heading = {"field", "unit", "range", "meaning"};
  for (const FieldInfo& field : fields) {
    table.rows.push_back({field.key, unit_text(field.unit),
                          fixed_text(field.minimum, 2) + " to " + fixed_text(field.maximum, 2), field.meaning});
  }
  return table;
}

/// With what a config begins that says nothing but its model.
std::string start_text(const models::ModelDefaults& start) {
  const std::string swing = start.spread > 0 ? " that swings by " + value_text(start.spread) + "°" : "";
  return "cells of " + value_text(start.cell_size) + " m, a wind of strength " + value_text(start.strength) + swing +
         ", " + value_text(start.sand) + " slabs a cell";
}

std::string weather_text(const ModelInfo& info) {
  return info.channels.empty() ? "nothing" : join(info.channels, ", ");
}

ExitCode print_models() {
  TextTable table;
  table.heading = {"model", "title", "makes"};
  for (const ModelType& type : models::catalogue())
    table.rows.push_back({type.info.key, type.info.title, type.info.produces});
  std::cout << table.aligned();
  return exit_done;
}

ExitCode print_model(const std::string& key, bool markdown) {
  const ModelType& type = models::find_model(key);
  const ModelInfo& info = type.info;
  const std::vector<std::string> meanings = sim::explain(sim::Config(type));
  const char* bullet = markdown ? "- " : "  ";

  std::cout << (markdown ? "# " : "") << info.title << " (`" << info.key << "`)\n\n";
  if (markdown) std::cout << "Made by `erg model " << key << " --markdown`; the program declares all of it.\n\n";
  std::cout << bullet << "Published in: " << info.citation << "\n"
            << bullet << "Makes: " << info.produces << "\n"
            << bullet << "Leaves out: " << info.limitations << "\n"
            << bullet << "A time step: " << info.step << "\n"
            << bullet << "Wind strength: " << info.strength_label << "\n"
            << bullet << "Asks for, besides the wind: " << weather_text(info) << "\n"
            << bullet << "Starts with: " << start_text(info.start) << "\n";
  std::cout << (markdown ? "\n## Parameters\n\n" : "\nParameters\n\n");
  const TextTable parameters = parameter_table(type.parameters);
  std::cout << (markdown ? parameters.markdown() : parameters.aligned());
  if (!type.fields.empty()) {
    const TextTable fields = field_table(type.fields);
    std::cout << (markdown ? "\n## Fields\n\n" : "\nFields\n\n") << (markdown ? fields.markdown() : fields.aligned());
  }
  if (!meanings.empty()) {
    std::cout << (markdown ? "\n## What the defaults mean" : "\nWhat the defaults mean") << ", with cells of "
              << value_text(info.start.cell_size) << " m\n\n";
    for (const std::string& meaning : meanings) std::cout << bullet << meaning << "\n";
  }
  return exit_done;
}

}  // namespace

void add_models_command(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand("models", "List the models");
  command->callback([&action] { action = print_models; });
}

void add_model_command(CLI::App& program, Action& action) {
  struct Options {
    std::string key;
    bool markdown = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("model", "Show a model and its parameters");
  command->add_option("NAME", options->key, "Key of the model (`erg models` lists them)")->required();
  command->add_flag("--markdown", options->markdown, "Write Markdown, as in docs/models/");
  command->callback(
      [&action, options] { action = [options] { return print_model(options->key, options->markdown); }; });
}

}  // namespace erg::app
