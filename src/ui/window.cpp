#include "ui/window.h"

#include <imgui.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "core/errors.h"
#include "render/gl.h"
#include "render/gl_context.h"
#include "ui/clipboard.h"
#include "ui/gui.h"

// GLEW is first to define OpenGL; freeglut only wants its types.
#include <GL/freeglut.h>
#include <GL/freeglut_ucall.h>
#include <GL/glx.h>

namespace erg {
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
    throw InputError("DISPLAY", "nothing answers at " + in_quotes(name), remedy_display);
  }
  return display;
}

/// A side of the window: as wanted (0: as usual at the screen's scale), but no longer than the screen's.
int on_screen(int wanted, double usual, int screen) {
  const double side = wanted > 0 ? wanted : usual * scale_of_screen(glutGet(GLUT_SCREEN_HEIGHT));
  return screen > 0 ? std::min(static_cast<int>(side), screen) : static_cast<int>(side);
}

/// For XCheckIfEvent: the window manager's wish to close the window. `atom` points to the one that says so.
Bool is_close_wish(::Display*, XEvent* event, XPointer atom) {
  return event->type == ClientMessage &&
         static_cast<Atom>(event->xclient.data.l[0]) == *reinterpret_cast<const Atom*>(atom);
}

int place_of_special(int key) {
  switch (key) {
    case GLUT_KEY_LEFT:
      return keys::left;
    case GLUT_KEY_RIGHT:
      return keys::right;
    case GLUT_KEY_UP:
      return keys::up;
    case GLUT_KEY_DOWN:
      return keys::down;
    case GLUT_KEY_PAGE_UP:
      return keys::page_up;
    case GLUT_KEY_PAGE_DOWN:
      return keys::page_down;
    case GLUT_KEY_HOME:
      return keys::home;
    case GLUT_KEY_END:
      return keys::end;
    case GLUT_KEY_INSERT:
      return keys::insert;
    case GLUT_KEY_DELETE:
      return keys::remove;
    default:
      break;
  }
  return key >= GLUT_KEY_F1 && key <= GLUT_KEY_F12 ? keys::function + 1 + key - GLUT_KEY_F1 : -1;
}

// The place of a character's key. With Ctrl held, letters come as 1 to 26.
int place_of_character(unsigned char character, bool ctrl) {
  const int code = character;
  if (ctrl && code >= 1 && code <= 26 && code != keys::backspace && code != keys::tab && code != keys::enter) {
    return code + 'A' - 1;
  }
  return code >= 'a' && code <= 'z' ? code - 'a' + 'A' : code;
}

}  // namespace

// What the callbacks work on.
struct Window::Hidden {
  int handle = 0;
  int width = 1;
  int height = 1;
  int redraw = settling_frames;
  bool software = false;
  bool running = false;
  WindowEvents events;
  std::exception_ptr failure;
  Clock::time_point last_frame = Clock::now();
  Clipboard clipboard;

  // Exceptions may not fly through freeglut's C.
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
  void wake() {
    redraw = settling_frames;
    glutPostRedisplay();
  }

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
  // freeglut would destroy the window before anybody could be asked: its wish to close is taken out of the queue.
  void take_close_wish(::Display* display) {
    Atom wish = XInternAtom(display, "WM_DELETE_WINDOW", False);
    XEvent event;
    while (XCheckIfEvent(display, &event, is_close_wish, reinterpret_cast<XPointer>(&wish))) {
      guarded([this] { events.close_wanted(); });
      wake();
    }
  }
  // Sleeps until there is input, but no longer than a frame while busy.
  static void wait_for_input(::Display* display, bool busy) {
    if (XPending(display) > 0) return;
    pollfd waiting{ConnectionNumber(display), POLLIN, 0};
    poll(&waiting, 1, busy ? frame_milliseconds : rest_milliseconds);
  }

  void take_modifiers() const {
    ImGuiIO& io = ImGui::GetIO();
    const int held = glutGetModifiers();
    io.KeyCtrl = (held & GLUT_ACTIVE_CTRL) != 0;
    io.KeyShift = (held & GLUT_ACTIVE_SHIFT) != 0;
    io.KeyAlt = (held & GLUT_ACTIVE_ALT) != 0;
  }
  void take_character(unsigned char character, bool down) {
    take_modifiers();
    ImGuiIO& io = ImGui::GetIO();
    io.KeysDown[place_of_character(character, io.KeyCtrl)] = down;
    if (!down && character >= 1 && character <= 26) io.KeysDown[character + 'A' - 1] = false;  // Ctrl was let go first
    if (down && !io.KeyCtrl && character >= 32 && character != 127) io.AddInputCharacter(character);
    if (down) show_frame();  // a key that comes and goes between two frames would not be seen
    wake();
  }
  void take_special(int key, bool down) {
    take_modifiers();
    const int place = place_of_special(key);
    if (place >= 0) ImGui::GetIO().KeysDown[place] = down;
    if (down) show_frame();
    wake();
  }
  void take_button(int button, bool down, int x, int y) {
    take_modifiers();
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = {static_cast<float>(x), static_cast<float>(y)};
    if (button == 3 || button == 4) {
      if (down) io.MouseWheel += button == 3 ? 1.0f : -1.0f;
    } else if (button >= GLUT_LEFT_BUTTON && button <= GLUT_RIGHT_BUTTON) {
      const int imgui_button = button == GLUT_LEFT_BUTTON ? 0 : button == GLUT_RIGHT_BUTTON ? 1 : 2;
      io.MouseDown[imgui_button] = down;
      show_frame();  // likewise a click
    }
    wake();
  }
  void take_place(int x, int y) {
    ImGui::GetIO().MousePos = {static_cast<float>(x), static_cast<float>(y)};
    wake();
  }
  void install();
};

void Window::Hidden::install() {
  glutDisplayFuncUcall([](void* data) { static_cast<Hidden*>(data)->show_frame(); }, this);
  glutReshapeFuncUcall(
      [](int wide, int high, void* data) {
        auto* const hidden = static_cast<Hidden*>(data);
        hidden->width = std::max(wide, 1);
        hidden->height = std::max(high, 1);
        hidden->wake();
      },
      this);
  glutKeyboardFuncUcall(
      [](unsigned char key, int, int, void* data) { static_cast<Hidden*>(data)->take_character(key, true); }, this);
  glutKeyboardUpFuncUcall(
      [](unsigned char key, int, int, void* data) { static_cast<Hidden*>(data)->take_character(key, false); }, this);
  glutSpecialFuncUcall([](int key, int, int, void* data) { static_cast<Hidden*>(data)->take_special(key, true); },
                       this);
  glutSpecialUpFuncUcall([](int key, int, int, void* data) { static_cast<Hidden*>(data)->take_special(key, false); },
                         this);
  glutMouseFuncUcall([](int button, int state, int x, int y,
                        void* data) { static_cast<Hidden*>(data)->take_button(button, state == GLUT_DOWN, x, y); },
                     this);
  glutMotionFuncUcall([](int x, int y, void* data) { static_cast<Hidden*>(data)->take_place(x, y); }, this);
  glutPassiveMotionFuncUcall([](int x, int y, void* data) { static_cast<Hidden*>(data)->take_place(x, y); }, this);
  glutWMCloseFuncUcall(
      [](void* data) {
        // The window is being destroyed under us: what it holds is saved for the next start.
        auto* const hidden = static_cast<Hidden*>(data);
        hidden->guarded([&] { hidden->events.display_lost(); });
        hidden->leave();
      },
      this);
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
  const int width = on_screen(options.width, usual_width, glutGet(GLUT_SCREEN_WIDTH));
  const int height = on_screen(options.height, usual_height, glutGet(GLUT_SCREEN_HEIGHT));
  glutInitWindowSize(width, height);
  const int handle = glutCreateWindow(options.title.c_str());
  XSetErrorHandler(ignore_x_error);
  load_gl();
  hidden_ = std::make_unique<Hidden>();
  hidden_->handle = handle;
  hidden_->width = width;
  hidden_->height = height;
  driver_ = reinterpret_cast<const char*>(gl11().GetString(GL_RENDERER));
}

Window::~Window() {
  events_of_the_window = nullptr;
  glutSetWindow(hidden_->handle);
  glutCloseFunc(nullptr);  // freeglut would call it at the program's end, when there is nothing left to save
  glutDestroyWindow(hidden_->handle);
}

bool Window::is_software() const { return draws_in_software(driver_); }

int Window::screen_height() const { return glutGet(GLUT_SCREEN_HEIGHT); }

void Window::set_title(const std::string& title) { glutSetWindowTitle(title.c_str()); }

void Window::run(const WindowEvents& events) {
  hidden_->events = events;
  hidden_->running = true;
  hidden_->install();
  events_of_the_window = &hidden_->events;
  XSetIOErrorHandler([](Display*) -> int {
    std::string words = "the display is gone";
    if (events_of_the_window != nullptr) words = events_of_the_window->display_lost();
    std::fprintf(stderr, "erg: %s\n", words.c_str());
    // Xlib ends the program when this returns; without the destructors of a window that is no more.
    std::_Exit(1);
  });
  // freeglut's own loop would take the OpenGL context away at its end, before those who drew with it let go of it.
  ::Display* const display = glXGetCurrentDisplay();
  while (hidden_->running) {
    hidden_->take_close_wish(display);
    hidden_->close_if_it_must();
    glutMainLoopEvent();
    const bool busy = hidden_->is_busy();
    if (busy) glutPostRedisplay();
    Hidden::wait_for_input(display, busy);
  }
  if (hidden_->failure) std::rethrow_exception(hidden_->failure);
}

void Window::close() { hidden_->leave(); }

}  // namespace erg
