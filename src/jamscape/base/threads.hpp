// Independent jobs on a few threads.
#pragma once

#include <cstddef>
#include <functional>

namespace jam {

/// Runs job(0) ... job(count - 1), each once, starting them in that order on up to `threads` threads, and returns
/// when all have ended. The calling thread waits meanwhile and calls `idle` (if any) about every `interval` seconds and
/// once more at the end. The first exception of a job is rethrown after the others have ended; jobs not yet begun by
/// then are left out.
void run_jobs(std::size_t count, int threads, const std::function<void(std::size_t)>& job,
              const std::function<void()>& idle = {}, double interval = 0.25);

}  // namespace jam
