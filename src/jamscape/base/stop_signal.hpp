// Ctrl-C and termination as a polite request: the first asks, the second kills.
#pragma once

namespace jam {

/// From now on the first SIGINT or SIGTERM only sets the flag; a second one ends the process as usual.
void watch_stop_signals();

/// True once such a signal has come.
bool stop_requested() noexcept;

}  // namespace jam
