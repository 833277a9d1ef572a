#include "jamscape/base/stop_signal.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>

namespace jam {
namespace {

/// In a process of its own, since signals belong to one: what it ends with.
template <class Work>
int status_of(Work work) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(work());
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

TEST(StopSignal, EveryOneAsksAndMayComeAgain) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU, SIGPIPE, SIGALRM, SIGVTALRM, SIGPWR}) {
    const int status = status_of([signal] {
      std::signal(SIGHUP, SIG_DFL);
      watch_stop_signals();
      if (stop_requested()) return 1;
      std::raise(signal);
      std::raise(signal);
      return stop_requested() ? 0 : 2;
    });
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << ::strsignal(signal);
  }
}

TEST(StopSignal, NohupStaysInForce) {
  const int status = status_of([] {
    std::signal(SIGHUP, SIG_IGN);
    watch_stop_signals();
    std::raise(SIGHUP);
    return stop_requested() ? 1 : 0;
  });
  EXPECT_EQ(status, 0);
}

TEST(StopSignal, BlockedOnesAreLetThrough) {
  const int status = status_of([] {
    sigset_t blocked;
    sigemptyset(&blocked);
    sigaddset(&blocked, SIGUSR1);
    sigprocmask(SIG_BLOCK, &blocked, nullptr);
    watch_stop_signals();
    std::raise(SIGUSR1);
    return stop_requested() ? 0 : 1;
  });
  EXPECT_EQ(status, 0);
}

TEST(StopSignal, ASecondInterruptLaterEndsTheProcess) {
  const int status = status_of([] {
    watch_stop_signals();
    std::raise(SIGINT);
    ::usleep(1100000);
    std::raise(SIGINT);
    return 0;
  });
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT);
}

}  // namespace
}  // namespace jam
