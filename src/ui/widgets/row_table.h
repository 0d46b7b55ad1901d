// A list of rows that people edit: a table to choose from, and buttons that add, copy, remove and move.
#pragma once

#include <cstddef>
#include <string>

#include "ui/widgets/widgets.h"

namespace erg::ui {

/// What the buttons under a list do to it.
enum class ListEdit { none, add, copy, remove, up, down };

/// A list as its buttons see it.
struct ListState {
  std::string row_name = "row";  ///< what people call one
  std::size_t count = 0;
  std::size_t selected = 0;
  std::size_t fewest = 0;
  std::size_t most = SIZE_MAX;
};
/// ADD, COPY, REMOVE and the arrows; those that cannot be pressed say why.
ListEdit list_buttons(const ListState& list);

/// A parameter whose value is a list of rows: the table of all, the buttons, and the values of the chosen row, each as
/// its column is declared.
RowEvent rows_row(const Row& row, const Parameter& parameter, RowList& list);

}  // namespace erg::ui
