// UNSAVED: the question before work is left that stands in no file.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "ui/panels/panel.h"

namespace erg::ui {

inline constexpr const char* unsaved_title = "UNSAVED";

/// What waits for the answer.
struct Parting {
  std::string what;           ///< on its button: "QUIT"
  session::Leaves leaves;     ///< what would be lost by it
  std::function<void()> act;  ///< done when all is saved, or the person does not want to
};

/// `parting` must outlive the panel; the panel clears it.
std::unique_ptr<Panel> make_unsaved_panel(std::optional<Parting>& parting);

}  // namespace erg::ui
