// All panels of the window, in the order in which they stand in their docks.
#pragma once

#include <memory>
#include <vector>

#include "ui/panels/panel.h"

namespace erg::ui {

/// Titles of the panels that menus and keys open with PanelContext::open.
namespace panel_title {
inline constexpr const char* setup = "SETUP";
inline constexpr const char* wind = "WIND";
inline constexpr const char* temperature = "TEMPERATURE";
inline constexpr const char* numbers = "NUMBERS";
inline constexpr const char* section = "SECTION";
inline constexpr const char* paint = "PAINT";
inline constexpr const char* compare = "COMPARE";
inline constexpr const char* gallery = "GALLERY";
inline constexpr const char* open = "OPEN";
inline constexpr const char* save = "SAVE AS";
inline constexpr const char* export_files = "EXPORT";
inline constexpr const char* log = "LOG";
inline constexpr const char* keys = "KEYS";
inline constexpr const char* about = "ABOUT";
inline constexpr const char* recovery = "RECOVERY";
}  // namespace panel_title

// One maker a panel; each is in a file of its own.
std::unique_ptr<Panel> make_setup_panel();
std::unique_ptr<Panel> make_wind_panel();
std::unique_ptr<Panel> make_temperature_panel();
std::unique_ptr<Panel> make_numbers_panel();
std::unique_ptr<Panel> make_section_panel();
std::unique_ptr<Panel> make_paint_panel();
std::unique_ptr<Panel> make_compare_panel();
std::unique_ptr<Panel> make_gallery_panel();
std::unique_ptr<Panel> make_open_panel();
std::unique_ptr<Panel> make_save_panel();
std::unique_ptr<Panel> make_export_panel();
std::unique_ptr<Panel> make_log_panel();
std::unique_ptr<Panel> make_keys_panel();
std::unique_ptr<Panel> make_about_panel();
std::unique_ptr<Panel> make_recovery_panel();

/// All of them.
std::vector<std::unique_ptr<Panel>> make_panels();

}  // namespace erg::ui
