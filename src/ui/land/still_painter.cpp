#include "ui/land/still_painter.h"

#include <sys/resource.h>

#include <exception>
#include <utility>

#include "render/gl_context.h"
#include "render/renderer.h"
#include "render/textures.h"
#include "ui/land/terrain_panes.h"

namespace erg::ui {

using render::Renderer;

namespace {

/// One renderer for each run, which keeps what did not change from picture to picture.
class Easel {
 public:
  std::vector<StillPicture> draw(const StillOrder& order) {
    renderers_.resize(order.parts.size());
    std::vector<StillPicture> pictures;
    for (std::size_t i = 0; i < order.parts.size(); ++i) {
      if (renderers_[i] == nullptr) renderers_[i] = std::make_unique<Renderer>();
      renderers_[i]->set_quality(order.quality);
      const StillOrder::Part& part = order.parts[i];
      StillPicture picture{part.width, part.height, {}, {}};
      target_.prepare(part.width, part.height);
      picture.notes = renderers_[i]->draw_into(target_.frame(), view_of_run(part.run), order.look, order.camera,
                                               part.width, part.height);
      picture.pixels = target_.read();
      pictures.push_back(std::move(picture));
    }
    return pictures;
  }

 private:
  std::vector<std::unique_ptr<Renderer>> renderers_;
  render::PictureTarget target_;
};

}  // namespace

StillPainter::StillPainter() : thread_([this] { work(); }) {
  std::unique_lock lock(mutex_);
  told_.wait(lock, [this] { return ready_; });
}

StillPainter::~StillPainter() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  told_.notify_all();
  thread_.join();
}

void StillPainter::order(StillOrder order) {
  {
    const std::lock_guard lock(mutex_);
    order_ = std::move(order);
    drawn_.reset();
  }
  told_.notify_all();
}

bool StillPainter::busy() const {
  const std::lock_guard lock(mutex_);
  return order_.has_value() || drawing_;
}

std::optional<std::vector<StillPicture>> StillPainter::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(drawn_, std::nullopt);
}

void StillPainter::work() {
  // Threads that the driver starts from here inherit it: under Linux a priority is a thread's own.
  constexpr int politeness = 10;
  setpriority(PRIO_PROCESS, 0, politeness);
  std::unique_ptr<render::GlContext> context;
  try {
    context = render::make_egl_context();
  } catch (const std::exception&) {
    // Without one the window draws its still pictures itself.
  }
  {
    const std::lock_guard lock(mutex_);
    works_ = context != nullptr;
    ready_ = true;
  }
  told_.notify_all();
  if (context != nullptr) draw_orders();
}

void StillPainter::draw_orders() {
  Easel easel;
  std::unique_lock lock(mutex_);
  while (true) {
    told_.wait(lock, [this] { return stopping_ || order_; });
    if (stopping_) return;
    const StillOrder order = std::move(*order_);
    order_.reset();
    drawing_ = true;
    lock.unlock();
    std::vector<StillPicture> pictures;
    try {
      pictures = easel.draw(order);
    } catch (const std::exception&) {
      pictures.clear();  // no memory for them: the quick pictures stay
    }
    lock.lock();
    drawing_ = false;
    drawn_ = std::move(pictures);
  }
}

}  // namespace erg::ui
