// LOOK: material or values, palette, contours, sun, camera, extras.
#pragma once

#include <memory>

#include "ui/land/view_state.h"
#include "ui/panels/panel.h"

namespace erg::ui {

inline constexpr const char* look_title = "LOOK";

/// `view_state` and `bookmarks` must outlive the panel.
std::unique_ptr<Panel> make_look_panel(ViewState& view_state, Bookmarks& bookmarks);

/// The looks that a run can be seen in: key and label.
struct LookChoice {
  std::string key;
  std::string label;
};
/// Those of run number `run` of a snapshot; where there is no such run, those that every terrain has.
std::vector<LookChoice> look_choices(const session::Snapshot& now, std::size_t run);

}  // namespace erg::ui
