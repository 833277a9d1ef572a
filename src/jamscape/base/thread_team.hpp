// A few threads that work through one short piece of work after another, microseconds apart.
//
// run() deals its items out in equal shares, one a thread; who has done its own takes from the others. It returns when
// all items have ended, not when all threads have looked: a thread that has no core at the moment holds nobody up.
// Between two pieces the threads spin for some microseconds, then sleep. Which thread has an item is chance: results
// may not depend on it.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <type_traits>
#include <vector>

namespace jam {

class ThreadTeam {
 public:
  /// The calling thread is one of `threads`; a team of one starts none.
  explicit ThreadTeam(int threads = 1);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  int size() const { return size_; }

  /// job(0) ... job(count - 1), each once, under the calling thread's treatment of denormals; what they wrote is
  /// visible afterwards. Rethrows one of the exceptions thrown, after all have ended. Not from two threads at once, nor
  /// from within a job.
  template <class Job>
  void run(std::size_t count, Job&& job) {
    if (size_ == 1 || count < 2) {
      for (std::size_t k = 0; k < count; ++k) job(k);
      return;
    }
    using Plain = std::remove_reference_t<Job>;
    deal(
        count, [](void* of, std::size_t k) { (*static_cast<Plain*>(of))(k); },
        const_cast<void*>(static_cast<const void*>(&job)));
  }

 private:
  using Call = void (*)(void*, std::size_t);

  /// One thread's share. `left` counts its items and holds the piece's number in its upper half, so that who comes late
  /// takes nothing of another piece.
  struct alignas(64) Share {
    std::atomic<std::uint64_t> left{0};
    std::atomic<std::uint32_t> first{0};
  };

  void deal(std::size_t count, Call call, void* job);
  void serve(std::size_t member);
  void take_all(std::uint32_t piece, std::size_t member);

  int size_;
  std::unique_ptr<Share[]> shares_;
  alignas(64) std::atomic<std::uint32_t> piece_{0};  ///< number of the piece under way
  std::atomic<bool> over_{false};
  std::atomic<Call> call_{nullptr};
  std::atomic<void*> job_{nullptr};
  std::atomic<unsigned> rounding_{0};
  alignas(64) std::atomic<std::uint32_t> left_{0};  ///< items that have not ended
  std::mutex mutex_;
  std::exception_ptr failure_;
  std::vector<std::thread> members_;
};

}  // namespace jam
