// The most a call has on the heap at a time, in bytes, beyond what was there before. Counted by the operators new and
// delete that heap_peak.cpp replaces; while nothing is counted they cost one test. For one thread.
#pragma once

#include <functional>

double heap_peak(const std::function<void()>& call);
