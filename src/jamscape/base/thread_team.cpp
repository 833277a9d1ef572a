#include "jamscape/base/thread_team.hpp"

#include <algorithm>
#include <utility>

#include "jamscape/base/error.hpp"
#include "jamscape/base/flush_to_zero.hpp"

namespace jam {
namespace {

/// Looks before a thread sleeps, some 50 us; less lets it sleep between the passes of a step, more burns time that
/// others could use.
constexpr int patience = 1500;

void pause() {
#if defined(__SSE2__)
  _mm_pause();
#else
  std::this_thread::yield();
#endif
}

}  // namespace

ThreadTeam::ThreadTeam(int threads)
    : size_(std::max(1, threads)), shares_(std::make_unique<Share[]>(static_cast<std::size_t>(size_))) {
  for (std::size_t m = 1; m < static_cast<std::size_t>(size_); ++m) members_.emplace_back([this, m] { serve(m); });
}

ThreadTeam::~ThreadTeam() {
  over_.store(true, std::memory_order_relaxed);
  piece_.fetch_add(1, std::memory_order_release);
  piece_.notify_all();
  for (auto& member : members_) member.join();
}

void ThreadTeam::deal(std::size_t count, Call call, void* job) {
  if (count > UINT32_MAX) throw Error(ExitCode::bug, "a piece of work of more than 2^32 items");
  const std::uint32_t piece = piece_.load(std::memory_order_relaxed) + 1;
  const auto threads = static_cast<std::size_t>(size());
  call_.store(call, std::memory_order_relaxed);
  job_.store(job, std::memory_order_relaxed);
  rounding_.store(float_control(), std::memory_order_relaxed);
  left_.store(static_cast<std::uint32_t>(count), std::memory_order_relaxed);
  for (std::size_t t = 0; t < threads; ++t) {
    const std::size_t first = count * t / threads, end = count * (t + 1) / threads;
    shares_[t].first.store(static_cast<std::uint32_t>(first), std::memory_order_relaxed);
    shares_[t].left.store(std::uint64_t{piece} << 32 | (end - first), std::memory_order_release);
  }
  piece_.store(piece, std::memory_order_release);
  piece_.notify_all();
  take_all(piece, 0);
  for (int looks = 0; left_.load(std::memory_order_acquire) != 0; ++looks)
    looks < patience ? pause() : std::this_thread::yield();
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void ThreadTeam::take_all(std::uint32_t piece, std::size_t member) {
  const auto threads = static_cast<std::size_t>(size());
  for (std::size_t t = 0; t < threads; ++t) {
    Share& share = shares_[(member + t) % threads];
    std::uint64_t left = share.left.load(std::memory_order_acquire);
    while (left >> 32 == piece && static_cast<std::uint32_t>(left) != 0) {
      if (!share.left.compare_exchange_weak(left, left - 1, std::memory_order_acq_rel)) continue;
      // An item taken keeps its piece from ending: what is read now belongs to it.
      const std::size_t item = share.first.load(std::memory_order_relaxed) + static_cast<std::uint32_t>(left) - 1;
      try {
        call_.load(std::memory_order_relaxed)(job_.load(std::memory_order_relaxed), item);
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = std::current_exception();
      }
      left_.fetch_sub(1, std::memory_order_acq_rel);
      left = share.left.load(std::memory_order_acquire);
    }
  }
}

void ThreadTeam::serve(std::size_t member) {
  for (std::uint32_t seen = 0;;) {
    for (int looks = 0; looks < patience && piece_.load(std::memory_order_acquire) == seen; ++looks) pause();
    piece_.wait(seen, std::memory_order_acquire);
    seen = piece_.load(std::memory_order_acquire);
    if (over_.load(std::memory_order_relaxed)) return;
    set_float_control(rounding_.load(std::memory_order_relaxed));
    take_all(seen, member);
  }
}

}  // namespace jam
