// PICTURE: the terrain as a PNG of any size.
#pragma once

#include <functional>
#include <memory>

#include "ui/window/shell.h"

namespace erg::ui {

inline constexpr const char* picture_title = "PICTURE";

/// `save` draws and writes; it may throw InputError.
std::unique_ptr<Panel> make_picture_panel(std::function<void(const PictureOrder&)> save);

}  // namespace erg::ui
