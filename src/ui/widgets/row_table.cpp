#include "ui/widgets/row_table.h"

#include <algorithm>
#include <utility>

namespace erg::ui {
namespace {

/// A table of all rows; a click chooses one.
void draw_table(const Parameter& parameter, const RowList& list, std::size_t& selected) {
  constexpr ImGuiTableFlags flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp;
  const auto columns = static_cast<int>(parameter.columns.all().size()) + 1;
  if (!ImGui::BeginTable("rows", columns, flags)) return;
  ImGui::TableSetupColumn("", 0, 0.5f);
  for (const Parameter& column : parameter.columns) ImGui::TableSetupColumn(column.label.c_str(), 0, 1);
  ImGui::TableHeadersRow();
  for (std::size_t index = 0; index < list.rows.size(); ++index) {
    ImGui::TableNextColumn();
    const std::string number = std::to_string(index + 1);
    if (ImGui::Selectable(number.c_str(), index == selected, ImGuiSelectableFlags_SpanAllColumns)) selected = index;
    mark(parameter.row_name + " " + number);
    for (const Parameter& column : parameter.columns) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(value_text(list.rows[index].value(column.key)).c_str());
    }
  }
  ImGui::EndTable();
}

/// Does what a button says; the row that is chosen then.
std::size_t apply(ListEdit edit, const Parameter& parameter, std::vector<ParameterValues>& rows, std::size_t selected) {
  const auto at = rows.begin() + static_cast<std::ptrdiff_t>(selected);
  switch (edit) {
    case ListEdit::none:
      return selected;
    case ListEdit::add:
      rows.emplace_back(parameter.columns);
      return rows.size() - 1;
    case ListEdit::copy: {
      ParameterValues copy = *at;
      rows.insert(at + 1, std::move(copy));
      return selected + 1;
    }
    case ListEdit::remove:
      rows.erase(at);
      return std::min(selected, std::max<std::size_t>(rows.size(), 1) - 1);
    case ListEdit::up:
      std::swap(rows[selected], rows[selected - 1]);
      return selected - 1;
    case ListEdit::down:
      std::swap(rows[selected], rows[selected + 1]);
      return selected + 1;
  }
  return selected;
}

bool draw_row_values(ParameterValues& row) {
  bool changed = false;
  for (const Parameter& column : row.declared()) {
    if (!row.is_active(column)) continue;
    ParameterValue value = row.value(column.key);
    const RowEvent event = parameter_row(column, value);
    if (event == RowEvent::reset) row.reset(column.key);
    if (event == RowEvent::changed) row.set(column.key, std::move(value));
    changed = changed || event != RowEvent::none;
  }
  return changed;
}

}  // namespace

ListEdit list_buttons(const ListState& list) {
  const std::string& row = list.row_name;
  const std::string none = list.count == 0 ? "There is no " + row + "." : "";
  const std::string full = list.count >= list.most ? "There may be no more of them." : "";
  const std::string few =
      list.count <= list.fewest ? "The list needs " + std::to_string(list.fewest) + " " + row + "." : none;
  ListEdit edit = ListEdit::none;
  if (button("ADD", {.tooltip = "Another " + row + " at the end.", .unavailable = full})) edit = ListEdit::add;
  ImGui::SameLine();
  if (button("COPY", {.tooltip = "The chosen " + row + " once more, right behind it.",
                      .unavailable = none.empty() ? full : none})) {
    edit = ListEdit::copy;
  }
  ImGui::SameLine();
  if (button("REMOVE", {.tooltip = "Takes the chosen " + row + " out.", .unavailable = few})) edit = ListEdit::remove;
  ImGui::SameLine();
  const bool first = list.selected == 0;
  if (button("\u2191##up", {.tooltip = "Earlier.", .unavailable = first ? "It is the first." : "", .name = "up"})) {
    edit = ListEdit::up;
  }
  ImGui::SameLine();
  const bool last = list.selected + 1 >= list.count;
  if (button("\u2193##down", {.tooltip = "Later.", .unavailable = last ? "It is the last." : "", .name = "down"})) {
    edit = ListEdit::down;
  }
  return edit;
}

RowEvent rows_row(const Row& row, const Parameter& parameter, RowList& list) {
  ImGui::TextUnformatted(row.label.c_str());
  mark(row.label);
  tooltip(row.tooltip);
  const WidgetScope scope(row.label);
  ImGui::BeginDisabled(!row.unavailable.empty());
  // Which row is chosen is the window's, not the value's.
  int* chosen = ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("chosen"), 0);
  std::size_t selected =
      std::min(static_cast<std::size_t>(std::max(*chosen, 0)), std::max<std::size_t>(list.rows.size(), 1) - 1);
  draw_table(parameter, list, selected);
  const ListEdit edit = list_buttons({.row_name = parameter.row_name,
                                      .count = list.rows.size(),
                                      .selected = selected,
                                      .fewest = static_cast<std::size_t>(parameter.minimum),
                                      .most = static_cast<std::size_t>(parameter.maximum)});
  selected = apply(edit, parameter, list.rows, selected);
  bool changed = edit != ListEdit::none;
  if (selected < list.rows.size()) changed = draw_row_values(list.rows[selected]) || changed;
  *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("chosen"), 0) = static_cast<int>(selected);
  ImGui::EndDisabled();
  return changed ? RowEvent::changed : RowEvent::none;
}

}  // namespace erg::ui
