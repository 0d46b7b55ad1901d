// A picture of the interface, drawn off the screen.
#pragma once

#include "picture/image.h"
#include "ui/widgets/gui.h"

namespace erg::test {

/// The last frame of `gui`.
picture::RgbImage picture_of_gui(const ui::Gui& gui, ImVec2 size);

}  // namespace erg::test
