// The window on the screen: freeglut stands in window.cpp and nowhere else.
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace erg::ui {

/// How the window opens.
struct WindowOptions {
  std::string title = "Erg";
  int width = 0;  ///< pixels, at most the screen's; 0: as suits the screen
  int height = 0;
};

/// What the window asks of the program that lives in it.
struct WindowEvents {
  /// Draws one frame of this size into the window's frame buffer 0; `seconds` since the last one.
  std::function<void(int width, int height, float seconds)> draw;
  /// Whether something changes by itself, so that frames should follow each other at once; otherwise the window rests
  /// until there is input, and asks again a few times a second.
  std::function<bool()> busy;
  /// The person wants to close the window: Window::close() does it, now or after a question.
  std::function<void()> close_wanted;
  /// Whether the window has to close now, without a question. Asked at least once a frame.
  std::function<bool()> must_close;
  /// The display is gone, and with it the window. Save what there is; the words returned are the last that are said.
  /// Runs in the midst of anything the window's thread was doing; the program ends right after.
  std::function<std::string()> display_lost;
};

/// The one window of the program. Its OpenGL context is current on the thread that made it. Mouse and keys go into the
/// current ImGui context's io.
class Window {
 public:
  /// Opens it. Throws InputError when there is no display, or no OpenGL 3.3 on it.
  explicit Window(const WindowOptions& options);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// What draws, in the driver's words.
  const std::string& driver() const { return driver_; }
  /// True when the processor draws.
  bool is_software() const;
  /// How many times its usual size the interface should be made on the monitor that the window is on now
  /// (ui/window/screen_scale.h).
  double suggested_scale() const;

  void set_title(const std::string& title);
  /// Shows frames and hands on input until the window is closed. What a callback throws comes out of here.
  void run(const WindowEvents& events);
  /// Ends run() after this frame.
  void close();

 private:
  struct Hidden;
  std::unique_ptr<Hidden> hidden_;
  std::string driver_;
};

}  // namespace erg::ui
