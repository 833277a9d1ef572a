// Whatever asks a program to end, as a polite request: Ctrl-C, a scheduler whose time is up, a lost terminal, a reader
// of the output who is gone.
#pragma once

namespace jam {

/// From now on SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU, SIGPIPE, SIGALRM, SIGVTALRM and SIGPWR only set the
/// flag, however often they come (schedulers repeat themselves); but a SIGINT a second or more after the first ends the
/// process as usual. A SIGHUP that was ignored (nohup) stays so. A file that grows too large (SIGXFSZ) is a failed
/// write and no signal. Call it before threads are started.
void watch_stop_signals();

/// True once such a signal has come.
bool stop_requested() noexcept;

}  // namespace jam
