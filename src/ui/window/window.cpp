#include "ui/window/window.h"

#include <imgui.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iterator>

#include "core/errors.h"
#include "render/gl.h"
#include "render/gl_context.h"
#include "ui/window/clipboard.h"
#include "ui/window/key_reader.h"
#include "ui/window/screen_scale.h"

// GLEW is first to define OpenGL; freeglut only wants its types.
#include <GL/freeglut.h>
#include <GL/freeglut_ucall.h>
#include <GL/glx.h>
#include <X11/Xutil.h>
#include <X11/extensions/XInput2.h>

namespace erg::ui {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int frame_milliseconds = 15;  // while busy: no more than about 60 frames a second
constexpr int rest_milliseconds = 50;   // at rest: how often the program is asked whether it is busy
constexpr double usual_width = 1280;    // pixels at scale 1
constexpr double usual_height = 800;
constexpr int settling_frames = 3;  // after input: what appears may take ImGui so many frames

constexpr const char* remedy_display =
    "start it from a desktop, or over ssh with -X; without a display `erg run` grows dunes and `erg render` draws them";

// X tells of a lost display through a function without any data of ours: these are the one window's events.
const WindowEvents* events_of_the_window = nullptr;

[[noreturn]] void fail_without_window(const char* why) {
  // Neither freeglut nor Xlib can go on from here, nor unwind; nothing has been opened yet that could be lost.
  std::fprintf(stderr,
               "erg: the window cannot be opened: %s; OpenGL version 3.3 is needed: install a newer driver, or "
               "libgl1-mesa-dri to draw on the processor\n",
               why);
  std::_Exit(1);
}

void take_glut_error(const char* format, va_list arguments, void*) {
  std::array<char, 256> why{};
  std::vsnprintf(why.data(), why.size(), format, arguments);
  fail_without_window(why.data());
}

int take_x_error(::Display* display, XErrorEvent* event) {
  std::array<char, 256> why{};
  XGetErrorText(display, event->error_code, why.data(), static_cast<int>(why.size()));
  fail_without_window(why.data());
}

// Xlib's own handler ends the program. What can go wrong while the window is there is another program's doing (one that
// asked for the copied text and is gone), and nothing is lost by it.
int ignore_x_error(::Display*, XErrorEvent*) { return 0; }

void ignore_warning(const char*, va_list, void*) {}

/// Held until the window has its own: a display that is its last client's to keep goes with that client.
using Connection = std::unique_ptr<Display, decltype(&XCloseDisplay)>;

Connection look_for_display() {
  const char* const name = std::getenv("DISPLAY");
  if (name == nullptr || *name == '\0') throw InputError("DISPLAY", "is not set: there is no screen", remedy_display);
  Connection display(XOpenDisplay(nullptr), XCloseDisplay);
  if (display == nullptr) {
    throw InputError("DISPLAY", "nothing answers at " + quote(name), remedy_display);
  }
  return display;
}

/// A side of the window: as wanted (0: as usual at this scale), but no longer than the monitor's.
int on_monitor(int wanted, double usual, int monitor, double scale) {
  const double side = wanted > 0 ? wanted : usual * scale;
  return monitor > 0 ? std::min(static_cast<int>(side), monitor) : static_cast<int>(side);
}

/// The monitor on which the pointer is, where a window manager is likely to put the window.
Monitor monitor_of_pointer(::Display* display) {
  ::Window ignored = 0;
  int x = 0, y = 0, unused = 0;
  unsigned buttons = 0;
  XQueryPointer(display, DefaultRootWindow(display), &ignored, &ignored, &x, &y, &unused, &unused, &buttons);
  return monitor_at(monitors_of(display), x, y);
}

/// freeglut asks for the mouse by the second input extension, which keeps the plain events from this window. (Were it
/// to read these events, it would leak one that comes when the window has just gone.)
void take_plain_mouse_events(::Display* display, ::Window window) {
  int count = 0;
  XIEventMask* const asked = XIGetSelectedEvents(display, window, &count);
  if (asked == nullptr || count <= 0) return;
  for (int i = 0; i < count; ++i) std::memset(asked[i].mask, 0, static_cast<std::size_t>(asked[i].mask_len));
  XISelectEvents(display, window, asked, count);
  XFree(asked);
}

}  // namespace

// What the loop works on. freeglut opens the window and keeps its OpenGL; X's events are read here, for freeglut knows
// keys by the characters of Latin-1 only.
struct Window::Hidden {
  int handle = 0;
  ::Display* display = nullptr;
  ::Window window = 0;
  Atom close_wish = 0;
  int width = 1;
  int height = 1;
  double scale = 1;
  bool has_moved = true;  // since its monitor was looked for: it may not open where the pointer is
  int redraw = settling_frames;
  bool running = false;
  WindowEvents events;
  std::exception_ptr failure;
  Clock::time_point last_frame = Clock::now();
  Clipboard clipboard;
  std::unique_ptr<KeyReader> keyboard;

  template <typename Work>
  void guarded(const Work& work) {
    try {
      work();
    } catch (...) {
      failure = std::current_exception();
      leave();
    }
  }
  void leave() { running = false; }
  void wake() { redraw = settling_frames; }

  void show_frame() {
    const Clock::time_point now = Clock::now();
    const float seconds = std::chrono::duration<float>(now - last_frame).count();
    last_frame = now;
    guarded([&] { events.draw(width, height, seconds); });
    glutSwapBuffers();
    redraw = std::max(redraw - 1, 0);
  }
  // Whether the next frame should come by itself.
  bool is_busy() {
    clipboard.answer();
    bool busy = redraw > 0;
    guarded([&] { busy = events.busy() || busy; });
    return busy;
  }
  void close_if_it_must() {
    guarded([this] {
      if (events.must_close()) leave();
    });
  }
  // Sleeps until there is input, but no longer than a frame while busy.
  void wait_for_input(bool busy) const {
    if (XPending(display) > 0) return;
    pollfd waiting{ConnectionNumber(display), POLLIN, 0};
    poll(&waiting, 1, busy ? frame_milliseconds : rest_milliseconds);
  }

  void take_events();
  void follow_monitor();
  void take(XEvent& event);
  void take_key(XEvent& event);
  void take_button(const XButtonEvent& button, bool down);
  void take_focus(bool here);
};

namespace {

void take_modifiers(unsigned state) {
  ImGuiIO& io = ImGui::GetIO();
  io.KeyCtrl = (state & ControlMask) != 0;
  io.KeyShift = (state & ShiftMask) != 0;
  io.KeyAlt = (state & Mod1Mask) != 0;
}

void take_place(int x, int y) { ImGui::GetIO().MousePos = {static_cast<float>(x), static_cast<float>(y)}; }

}  // namespace

void Window::Hidden::take_events() {
  while (running && XPending(display) > 0) {
    XEvent event;
    XNextEvent(display, &event);
    if (!keyboard->filters(event)) take(event);
  }
  if (running && has_moved) follow_monitor();
}

/// The monitor that the window's middle lies on says how large the interface is made.
void Window::Hidden::follow_monitor() {
  has_moved = false;
  int x = 0, y = 0;
  ::Window ignored = 0;
  XTranslateCoordinates(display, window, DefaultRootWindow(display), width / 2, height / 2, &x, &y, &ignored);
  scale = erg::ui::suggested_scale(desktop_dpi(display), monitor_at(monitors_of(display), x, y));
}

void Window::Hidden::take(XEvent& event) {
  if (event.type == MappingNotify) {
    XRefreshKeyboardMapping(&event.xmapping);
    return;
  }
  if (event.xany.window != window) return;
  switch (event.type) {
    case KeyPress:
    case KeyRelease:
      take_key(event);
      break;
    case ButtonPress:
    case ButtonRelease:
      take_button(event.xbutton, event.type == ButtonPress);
      break;
    case MotionNotify:
      take_place(event.xmotion.x, event.xmotion.y);
      break;
    case EnterNotify:
      take_place(event.xcrossing.x, event.xcrossing.y);
      break;
    case FocusIn:
    case FocusOut:
      take_focus(event.type == FocusIn);
      break;
    case ConfigureNotify:
      width = std::max(event.xconfigure.width, 1);
      height = std::max(event.xconfigure.height, 1);
      has_moved = true;
      break;
    case ClientMessage:
      // The window manager's wish: the person is asked first.
      if (static_cast<Atom>(event.xclient.data.l[0]) == close_wish) guarded([this] { events.close_wanted(); });
      break;
    case DestroyNotify:
      // The window is gone under us: what it held is saved for the next start.
      guarded([this] { events.display_lost(); });
      leave();
      return;
    case Expose:
    case MapNotify:
    case VisibilityNotify:
      break;
    default:
      return;  // nothing to be seen
  }
  wake();
}

void Window::Hidden::take_key(XEvent& event) {
  ImGuiIO& io = ImGui::GetIO();
  take_modifiers(event.xkey.state);
  const KeyStroke stroke = keyboard->read(event);
  if (stroke.place >= 0) io.KeysDown[stroke.place] = stroke.down;
  if (!stroke.text.empty()) io.AddInputCharactersUTF8(stroke.text.c_str());
  // A key that comes and goes between two frames would not be seen.
  if (stroke.down && (stroke.place >= 0 || !stroke.text.empty())) show_frame();
}

void Window::Hidden::take_button(const XButtonEvent& button, bool down) {
  ImGuiIO& io = ImGui::GetIO();
  take_modifiers(button.state);
  take_place(button.x, button.y);
  switch (button.button) {
    case Button1:
    case Button2:
    case Button3:
      io.MouseDown[button.button == Button1 ? 0 : button.button == Button3 ? 1 : 2] = down;
      show_frame();  // likewise a click
      break;
    case Button4:
    case Button5:
      if (down) io.MouseWheel += button.button == Button4 ? 1.0f : -1.0f;
      break;
    default:
      break;
  }
}

/// What is let go while another window has the keyboard is not told here.
void Window::Hidden::take_focus(bool here) {
  keyboard->set_focus(here);
  if (here) return;
  ImGuiIO& io = ImGui::GetIO();
  std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
  take_modifiers(0);
}

Window::Window(const WindowOptions& options) {
  const Connection connection = look_for_display();
  int count = 1;
  char name[] = "erg";
  char* arguments[] = {name, nullptr};
  glutInitErrorFuncUcall(take_glut_error, nullptr);
  XSetErrorHandler(take_x_error);
  glutInitWarningFuncUcall(ignore_warning, nullptr);
  glutInit(&count, arguments);
  glutInitContextVersion(3, 3);
  glutInitContextProfile(GLUT_CORE_PROFILE);
  glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGBA);
  glutSetOption(GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTION_CONTINUE_EXECUTION);
  const Monitor monitor = monitor_of_pointer(connection.get());
  const double scale = erg::ui::suggested_scale(desktop_dpi(connection.get()), monitor);
  const int width = on_monitor(options.width, usual_width, monitor.width, scale);
  const int height = on_monitor(options.height, usual_height, monitor.height, scale);
  glutInitWindowSize(width, height);
  const int handle = glutCreateWindow(options.title.c_str());
  XSetErrorHandler(ignore_x_error);
  render::load_gl();
  hidden_ = std::make_unique<Hidden>();
  hidden_->handle = handle;
  hidden_->width = width;
  hidden_->height = height;
  hidden_->scale = scale;
  hidden_->display = glXGetCurrentDisplay();
  hidden_->window = glXGetCurrentDrawable();
  hidden_->close_wish = XInternAtom(hidden_->display, "WM_DELETE_WINDOW", False);
  take_plain_mouse_events(hidden_->display, hidden_->window);
  hidden_->keyboard = std::make_unique<KeyReader>(hidden_->display, hidden_->window);
  driver_ = reinterpret_cast<const char*>(render::gl11().GetString(GL_RENDERER));
}

Window::~Window() {
  events_of_the_window = nullptr;
  hidden_->keyboard.reset();  // while there is a display
  glutSetWindow(hidden_->handle);
  glutDestroyWindow(hidden_->handle);
}

bool Window::is_software() const { return render::draws_in_software(driver_); }

double Window::suggested_scale() const { return hidden_->scale; }

void Window::set_title(const std::string& title) {
  // freeglut takes Latin-1 only.
  Xutf8SetWMProperties(hidden_->display, hidden_->window, title.c_str(), title.c_str(), nullptr, 0, nullptr, nullptr,
                       nullptr);
}

void Window::run(const WindowEvents& events) {
  hidden_->events = events;
  hidden_->running = true;
  events_of_the_window = &hidden_->events;
  XSetIOErrorHandler([](Display*) -> int {
    std::string words = "the display is gone";
    if (events_of_the_window != nullptr) words = events_of_the_window->display_lost();
    std::fprintf(stderr, "erg: %s\n", words.c_str());
    // Xlib ends the program when this returns; without the destructors of a window that is no more.
    std::_Exit(1);
  });
  while (hidden_->running) {
    hidden_->take_events();
    hidden_->close_if_it_must();
    const bool busy = hidden_->is_busy();
    if (busy && hidden_->running) hidden_->show_frame();
    if (hidden_->running) hidden_->wait_for_input(busy);
  }
  if (hidden_->failure) std::rethrow_exception(hidden_->failure);
}

void Window::close() { hidden_->leave(); }

}  // namespace erg::ui
