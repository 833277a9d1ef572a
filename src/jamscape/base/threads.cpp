#include "jamscape/base/threads.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace jam {

void run_jobs(std::size_t count, int threads, const std::function<void(std::size_t)>& job,
              const std::function<void()>& idle, double interval) {
  std::mutex mutex;
  std::condition_variable ended;
  std::size_t next = 0;
  std::exception_ptr failure;
  const std::size_t workers = std::min(count, static_cast<std::size_t>(std::max(1, threads)));
  std::size_t running = workers;

  const auto work = [&] {
    std::unique_lock lock(mutex);
    while (next < count && !failure) {
      const std::size_t k = next++;
      lock.unlock();
      std::exception_ptr error;
      try {
        job(k);
      } catch (...) {
        error = std::current_exception();
      }
      lock.lock();
      if (error && !failure) failure = error;
    }
    --running;
    ended.notify_one();
  };

  std::vector<std::jthread> pool;
  for (std::size_t k = 0; k < workers; ++k) pool.emplace_back(work);
  {
    std::unique_lock lock(mutex);
    while (!ended.wait_for(lock, std::chrono::duration<double>(interval), [&] { return running == 0; })) {
      lock.unlock();
      if (idle) idle();
      lock.lock();
    }
  }
  pool.clear();
  if (idle) idle();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace jam
