// A display that nobody sees, for tests of the window.
#ifndef PLUME_TESTS_VIRTUAL_DISPLAY_H
#define PLUME_TESTS_VIRTUAL_DISPLAY_H

#include <dlfcn.h>
#include <sys/prctl.h>

#include "tests/command/program.h"

namespace plume {

/// An X server on a free display, for as long as this lives.
class VirtualDisplay {
 public:
  VirtualDisplay() {
    int number_pipe[2];
    if (pipe(number_pipe) != 0) return;
    server_ = fork();
    if (server_ == 0) {
      const std::string number_to = std::to_string(number_pipe[1]);
      const int silence = open("/dev/null", O_WRONLY);
      dup2(silence, STDERR_FILENO);
      prctl(PR_SET_PDEATHSIG, SIGTERM);  // does not outlive a test that crashes
      execlp("Xvfb", "Xvfb", "-displayfd", number_to.c_str(), "-screen", "0", "1280x720x24", "-nolisten",
             "tcp", nullptr);
      _exit(127);
    }
    ::close(number_pipe[1]);
    char byte = 0;
    while (::read(number_pipe[0], &byte, 1) == 1 && byte != '\n')
      number_ += byte;  // nothing when it cannot start
    ::close(number_pipe[0]);
  }
  ~VirtualDisplay() {
    if (server_ <= 0) return;
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
  }
  VirtualDisplay(const VirtualDisplay&) = delete;

  /// Sends WM_DELETE_WINDOW, as a window manager does; none runs here. Xlib is there where GLFW is.
  void ask_to_close(unsigned long window) const {
    void* xlib = dlopen("libX11.so.6", RTLD_NOW);
    ASSERT_NE(xlib, nullptr);
    const auto open = reinterpret_cast<void* (*)(const char*)>(dlsym(xlib, "XOpenDisplay"));
    const auto atom =
        reinterpret_cast<unsigned long (*)(void*, const char*, int)>(dlsym(xlib, "XInternAtom"));
    const auto send =
        reinterpret_cast<int (*)(void*, unsigned long, int, long, void*)>(dlsym(xlib, "XSendEvent"));
    const auto close = reinterpret_cast<int (*)(void*)>(dlsym(xlib, "XCloseDisplay"));
    ASSERT_TRUE(open && atom && send && close);
    void* display = open((":" + number_).c_str());
    ASSERT_NE(display, nullptr);
    struct {  // XClientMessageEvent in the size of XEvent
      int type = 33;
      unsigned long serial = 0;
      int sent = 1;
      void* display = nullptr;
      unsigned long window = 0, protocols = 0;
      int format = 32;
      long data[5]{};
      long rest[12]{};
    } message;
    message.window = window;
    message.protocols = atom(display, "WM_PROTOCOLS", 0);
    message.data[0] = long(atom(display, "WM_DELETE_WINDOW", 0));
    send(display, window, 0, 0, &message);
    close(display);
  }
  bool works() const { return !number_.empty(); }
  Environment environment() const { return {{"DISPLAY", ":" + number_}, {"WAYLAND_DISPLAY", ""}}; }

 private:
  pid_t server_ = -1;
  std::string number_;
};

}  // namespace plume
#endif
