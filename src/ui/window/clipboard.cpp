#include "ui/window/clipboard.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <imgui.h>
#include <poll.h>

#include <chrono>

namespace erg::ui {
namespace {

constexpr std::chrono::milliseconds patience{300};  // for the program that owns the text

}  // namespace

struct Clipboard::Hidden {
  Display* display = XOpenDisplay(nullptr);
  ::Window window = 0;
  Atom clipboard = 0, targets = 0, utf8 = 0, received = 0;
  bool owner = false;
  std::string pasted;  // what ImGui last asked for; it keeps a pointer

  Hidden() {
    if (display == nullptr) return;
    window = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0);
    const auto atom = [&](const char* name) { return XInternAtom(display, name, False); };
    clipboard = atom("CLIPBOARD");
    targets = atom("TARGETS");
    utf8 = atom("UTF8_STRING");
    received = atom("ERG_CLIPBOARD");
  }
  ~Hidden() {
    if (display != nullptr) XCloseDisplay(display);
  }

  // Writes the text, or the list of kinds that it is offered as, where the asking program wants it.
  void serve(const XSelectionRequestEvent& request, const std::string& text) {
    XEvent reply{};
    XSelectionEvent& told = reply.xselection;
    told.type = SelectionNotify;
    told.requestor = request.requestor;
    told.selection = request.selection;
    told.target = request.target;
    told.time = request.time;
    told.property = request.property == None ? request.target : request.property;
    if (request.target == targets) {
      const Atom offered[] = {targets, utf8, XA_STRING};
      XChangeProperty(display, request.requestor, told.property, XA_ATOM, 32, PropModeReplace,
                      reinterpret_cast<const unsigned char*>(offered), 3);
    } else if (request.target == utf8 || request.target == XA_STRING) {
      XChangeProperty(display, request.requestor, told.property, request.target, 8, PropModeReplace,
                      reinterpret_cast<const unsigned char*>(text.data()), static_cast<int>(text.size()));
    } else {
      told.property = None;
    }
    XSendEvent(display, request.requestor, False, 0, &reply);
    XFlush(display);
  }

  std::string read_answer(Atom property) const {
    std::string text;
    Atom kind = 0;
    int bits = 0;
    unsigned long items = 0;
    unsigned long left = 0;
    unsigned char* bytes = nullptr;
    constexpr long most = 1L << 20;  // of 4 bytes
    if (XGetWindowProperty(display, window, property, 0, most, True, AnyPropertyType, &kind, &bits, &items, &left,
                           &bytes) == Success &&
        bytes != nullptr) {
      if (bits == 8) text.assign(reinterpret_cast<const char*>(bytes), items);
      XFree(bytes);
    }
    return text;
  }
};

Clipboard::Clipboard() : hidden_(std::make_unique<Hidden>()) {
  if (hidden_->display == nullptr) return;
  ImGuiIO& io = ImGui::GetIO();
  io.ClipboardUserData = this;
  io.SetClipboardTextFn = [](void* self, const char* text) { static_cast<Clipboard*>(self)->copy(text); };
  io.GetClipboardTextFn = [](void* self) {
    auto* const clipboard = static_cast<Clipboard*>(self);
    clipboard->hidden_->pasted = clipboard->paste();
    return clipboard->hidden_->pasted.c_str();
  };
}

Clipboard::~Clipboard() = default;

void Clipboard::copy(const std::string& text) {
  text_ = text;
  if (hidden_->display == nullptr) return;
  XSetSelectionOwner(hidden_->display, hidden_->clipboard, hidden_->window, CurrentTime);
  XFlush(hidden_->display);
  hidden_->owner = true;
}

void Clipboard::answer() {
  if (hidden_->display == nullptr) return;
  while (XPending(hidden_->display) > 0) {
    XEvent event{};
    XNextEvent(hidden_->display, &event);
    if (event.type == SelectionRequest) hidden_->serve(event.xselectionrequest, text_);
    if (event.type == SelectionClear) hidden_->owner = false;
  }
}

std::string Clipboard::paste() {
  answer();
  if (hidden_->display == nullptr || hidden_->owner) return text_;
  XConvertSelection(hidden_->display, hidden_->clipboard, hidden_->utf8, hidden_->received, hidden_->window,
                    CurrentTime);
  XFlush(hidden_->display);
  const auto end = std::chrono::steady_clock::now() + patience;
  while (std::chrono::steady_clock::now() < end) {
    XEvent event{};
    if (XCheckTypedEvent(hidden_->display, SelectionNotify, &event) == True) {
      return event.xselection.property == None ? std::string() : hidden_->read_answer(event.xselection.property);
    }
    pollfd waiting{ConnectionNumber(hidden_->display), POLLIN, 0};
    poll(&waiting, 1, 20);
  }
  return {};
}

}  // namespace erg::ui
