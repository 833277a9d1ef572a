#include "jamscape/base/stop_signal.hpp"

#include <atomic>
#include <csignal>

namespace jam {
namespace {

std::atomic<bool> stop_flag{false};  // the one piece of process-wide state: signals belong to the process

void request_stop(int signal) {
  stop_flag = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void watch_stop_signals() {
  struct sigaction action {};
  action.sa_handler = request_stop;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool stop_requested() noexcept { return stop_flag; }

}  // namespace jam
