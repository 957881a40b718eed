#include "sandbox/commands/interruption.h"

#include <csignal>

namespace plume {
namespace {

volatile std::sig_atomic_t g_interrupted = 0;

void note(int signal) {
  g_interrupted = 1;
  std::signal(signal, SIG_DFL);  // who asks twice does not want to wait for the frame
}

}  // namespace

void heed_interruptions() {
  std::signal(SIGINT, note);
  std::signal(SIGTERM, note);  // how schedulers say that time is up
}

bool is_interrupted() {
  return g_interrupted != 0;
}

}  // namespace plume
