// Still pictures drawn beside the window are those that the window would draw.
#include <gtest/gtest.h>

#include <chrono>
#include <set>
#include <thread>

#include "../session/snapshot_of.h"
#include "panel_hand.h"
#include "render/gl_context.h"
#include "render/renderer.h"
#include "render/textures.h"
#include "ui/land/still_painter.h"
#include "ui/land/terrain_panes.h"

namespace erg::test {

using render::PictureTarget;
using sim::Simulation;
using ui::StillPainter;

namespace {

TEST(StillPainter, DrawsEveryRunAsTheWindowWould) {
  StillPainter painter;
  ASSERT_TRUE(painter.works());
  EXPECT_FALSE(painter.take().has_value()) << "nothing was ordered";
  Simulation first(small_config());
  Simulation second(small_config());
  for (int step = 0; step < 20; ++step) second.step();
  ui::StillOrder order;
  order.camera = render::camera_preset("block", {32, 24, 0, 4}, 1.5);
  order.parts = {{snapshot_of(first, 1).runs.front(), 120, 80}, {snapshot_of(second, 2).runs.front(), 90, 60}};
  painter.order(order);
  while (painter.busy()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  const auto pictures = painter.take();
  ASSERT_TRUE(pictures.has_value());
  ASSERT_EQ(pictures->size(), 2u);
  EXPECT_FALSE(painter.take().has_value()) << "once";

  const auto context = render::make_egl_context();
  for (std::size_t i = 0; i < 2; ++i) {
    const ui::StillPicture& picture = (*pictures)[i];
    render::Renderer renderer;
    PictureTarget target;
    target.prepare(order.parts[i].width, order.parts[i].height);
    renderer.draw_into(target.frame(), ui::view_of_run(order.parts[i].run), order.look, order.camera, picture.width,
                       picture.height);
    EXPECT_EQ(picture.pixels, target.read()) << "run " << i + 1;
    EXPECT_GT(std::set(picture.pixels.begin(), picture.pixels.end()).size(), 20u) << "there is something to be seen";
    PictureTarget copy;
    copy.prepare(picture.width, picture.height);
    copy.write(picture.pixels);
    EXPECT_EQ(copy.read(), picture.pixels);
  }
}

}  // namespace
}  // namespace erg::test
