#include "jamscape/base/stop_signal.hpp"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>

namespace jam {
namespace {

// The one piece of process-wide state beside what file systems lack: signals belong to the process.
std::atomic<bool> stop_flag{false};
std::atomic<long> first_asked{0};  // milliseconds, never 0

static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<long>::is_always_lock_free, "used in a handler");

long now() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<long>(t.tv_sec) * 1000 + t.tv_nsec / 1000000 + 1;
}

void request_stop(int signal) {
  const int kept = errno;
  stop_flag = true;
  if (signal == SIGINT) {
    long none = 0;
    if (!first_asked.compare_exchange_strong(none, now()) && now() - first_asked >= 1000) {
      std::signal(signal, SIG_DFL);
      std::raise(signal);  // delivered when this handler returns
    }
  }
  errno = kept;
}

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

void watch_stop_signals() {
  struct sigaction action {};
  action.sa_handler = request_stop;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigset_t watched;
  sigemptyset(&watched);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU, SIGPIPE, SIGALRM, SIGVTALRM, SIGPWR}) {
    if (signal != SIGHUP || !is_ignored(signal)) sigaction(signal, &action, nullptr);
    sigaddset(&watched, signal);
  }
  pthread_sigmask(SIG_UNBLOCK, &watched, nullptr);  // some launchers leave them blocked
  std::signal(SIGXFSZ, SIG_IGN);
}

bool stop_requested() noexcept { return stop_flag; }

}  // namespace jam
