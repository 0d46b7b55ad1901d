#include "ui/panels/panels.h"

namespace erg::ui {

std::vector<std::unique_ptr<Panel>> make_panels() {
  using Maker = std::unique_ptr<Panel> (*)();
  constexpr Maker makers[] = {make_setup_panel,   make_wind_panel,  make_temperature_panel, make_numbers_panel,
                              make_section_panel, make_paint_panel, make_compare_panel,     make_gallery_panel,
                              make_open_panel,    make_save_panel,  make_export_panel,      make_log_panel,
                              make_keys_panel,    make_about_panel, make_recovery_panel};
  std::vector<std::unique_ptr<Panel>> panels;
  for (const Maker maker : makers) panels.push_back(maker());
  return panels;
}

}  // namespace erg::ui
