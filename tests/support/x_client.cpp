// Another program on the same display, for tests of the real window.
//
// usage: x_client drop WINDOW FILE...     drags files onto the middle of a window, as file managers do (XDND version 5)
//        x_client clipboard               prints the text in the clipboard
//        x_client offer TEXT              holds TEXT in the clipboard until it was fetched
//
// Exit code 0, or 1 with what went wrong on stderr. Nothing takes longer than a minute.
// XDND: https://freedesktop.org/wiki/Specifications/XDND/; selections: ICCCM, section 2.

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace {

constexpr long kVersion = 5;

class Client {
 public:
  Client() : display_(XOpenDisplay(nullptr)) {
    if (display_ == nullptr) fail("no display");
    own_ = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
  }
  ~Client() { XCloseDisplay(display_); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  Atom atom(const char* name) const { return XInternAtom(display_, name, False); }

  void drop(Window target, const std::string& uris) {
    type_ = atom("text/uri-list");
    text_ = uris;
    XSetSelectionOwner(display_, atom("XdndSelection"), own_, CurrentTime);
    send(target, "XdndEnter", kVersion << 24, static_cast<long>(type_), 0, 0);
    XWindowAttributes attributes;
    XGetWindowAttributes(display_, target, &attributes);
    int x = 0, y = 0;
    Window child = 0;
    XTranslateCoordinates(display_, target, DefaultRootWindow(display_), attributes.width / 2, attributes.height / 2, &x, &y, &child);
    send(target, "XdndPosition", 0, (static_cast<long>(x) << 16) | y, CurrentTime, static_cast<long>(atom("XdndActionCopy")));
    bool taken = false;
    wait("the window does not answer the drag", [&](const XEvent& event) {
      const bool status = event.type == ClientMessage && event.xclient.message_type == atom("XdndStatus");
      if (status) taken = (event.xclient.data.l[1] & 1) != 0;
      return status;
    });
    if (!taken) fail("the window does not take files");
    send(target, "XdndDrop", 0, CurrentTime, 0, 0);
    wait("the drop is not finished", [&](const XEvent& event) { return event.type == ClientMessage && event.xclient.message_type == atom("XdndFinished"); });
  }

  std::string clipboard() {
    const Atom property = atom("X_CLIENT");
    XConvertSelection(display_, atom("CLIPBOARD"), atom("UTF8_STRING"), property, own_, CurrentTime);
    std::string out;
    wait("nobody answers for the clipboard", [&](const XEvent& event) {
      if (event.type != SelectionNotify) return false;
      if (event.xselection.property == None) fail("the clipboard holds no text");
      Atom type = 0;
      int format = 0;
      unsigned long count = 0, left = 0;
      unsigned char* data = nullptr;
      XGetWindowProperty(display_, own_, property, 0, 1L << 22, True, AnyPropertyType, &type, &format, &count, &left, &data);
      out.assign(reinterpret_cast<const char*>(data), count);
      XFree(data);
      return true;
    });
    return out;
  }

  void offer(const std::string& text) {
    type_ = atom("UTF8_STRING");
    text_ = text;
    XSetSelectionOwner(display_, atom("CLIPBOARD"), own_, CurrentTime);
    std::puts("offered");
    std::fflush(stdout);
    wait("nobody fetches the text", [&](const XEvent&) { return given_; });
  }

 private:
  [[noreturn]] static void fail(const char* what) {
    std::fprintf(stderr, "x_client: %s\n", what);
    std::exit(1);
  }

  void send(Window target, const char* message, long first, long second, long third, long fourth) {
    XEvent event{};
    event.xclient = {ClientMessage, 0, True, display_, target, atom(message), 32, {}};
    const long data[] = {static_cast<long>(own_), first, second, third, fourth};
    for (int i = 0; i < 5; ++i) event.xclient.data.l[i] = data[i];
    XSendEvent(display_, target, False, NoEventMask, &event);
    XFlush(display_);
  }

  /// Hands out what is offered to whoever asks, until `done` says so of an event.
  void wait(const char* otherwise, const std::function<bool(const XEvent&)>& done) {
    for (const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1); std::chrono::steady_clock::now() < end;) {
      if (XPending(display_) == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        continue;
      }
      XEvent event;
      XNextEvent(display_, &event);
      if (event.type == SelectionRequest) answer(event.xselectionrequest);
      if (done(event)) return XFlush(display_), void();
    }
    fail(otherwise);
  }

  void answer(const XSelectionRequestEvent& wish) {
    XEvent event{};
    event.xselection = {SelectionNotify, 0, True, display_, wish.requestor, wish.selection, wish.target, None, wish.time};
    if (wish.target == atom("TARGETS")) {
      const Atom targets[] = {atom("TARGETS"), type_};
      XChangeProperty(display_, wish.requestor, wish.property, XA_ATOM, 32, PropModeReplace, reinterpret_cast<const unsigned char*>(targets), 2);
      event.xselection.property = wish.property;
    } else if (wish.target == type_) {
      XChangeProperty(display_, wish.requestor, wish.property, type_, 8, PropModeReplace, reinterpret_cast<const unsigned char*>(text_.data()), static_cast<int>(text_.size()));
      event.xselection.property = wish.property;
      given_ = true;
    }
    XSendEvent(display_, wish.requestor, False, NoEventMask, &event);
    XFlush(display_);
  }

  Display* display_;
  Window own_ = 0;
  Atom type_ = 0;
  std::string text_;
  bool given_ = false;
};

}  // namespace

int main(int count, char** words) {
  const std::vector<std::string> arguments(words + 1, words + count);
  const std::string what = arguments.empty() ? std::string() : arguments[0];
  Client client;
  if (what == "drop" && arguments.size() >= 3) {
    std::string uris;
    for (std::size_t i = 2; i < arguments.size(); ++i) uris += "file://" + arguments[i] + "\r\n";
    client.drop(std::stoul(arguments[1]), uris);
  } else if (what == "clipboard" && arguments.size() == 1) {
    std::fputs(client.clipboard().c_str(), stdout);
  } else if (what == "offer" && arguments.size() == 2) {
    client.offer(arguments[1]);
  } else {
    std::fputs("usage: x_client drop WINDOW FILE... | clipboard | offer TEXT\n", stderr);
    return 2;
  }
  return 0;
}
