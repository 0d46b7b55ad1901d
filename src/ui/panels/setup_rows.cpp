#include "ui/panels/setup_rows.h"

#include "ui/widgets/widgets.h"

namespace erg::ui {

using session::Setup;
using session::SetupRow;

namespace {

void draw_row(Setup& setup, const SetupRow& row) {
  ParameterValue value = row.value;
  const RowEvent event = parameter_row(*row.parameter, value, row.needs_new_terrain);
  if (event == RowEvent::reset) setup.reset(row.group, row.parameter->key);
  if (event == RowEvent::changed) setup.set(row.group, row.parameter->key, value);
}

}  // namespace

std::string draw_setup_rows(Setup& setup, const std::string& group, const sim::Config* running) {
  const WidgetScope scope(group);
  std::string wanted_path;
  for (const SetupRow& row : setup.rows(group, running)) {
    if (!row.relevant) continue;
    draw_row(setup, row);
    if (row.parameter->kind() != ParameterKind::path) continue;
    if (button("BROWSE", {.tooltip = "Choose the picture from your folders."})) wanted_path = row.parameter->key;
  }
  return wanted_path;
}

}  // namespace erg::ui
