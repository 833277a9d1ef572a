#include "jamscape/protocol/relaxation.hpp"

#include <algorithm>
#include <cmath>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

constexpr std::int64_t samples_per_window = 150;

}  // namespace

Relaxation::Relaxation(const RelaxOptions& options)
    : options_(options),
      interval_(std::max<std::int64_t>(1, options.window / samples_per_window)),
      per_window_(std::max<std::int64_t>(2, options.window / interval_)),
      kinetic_(static_cast<std::size_t>(per_window_), 0.0) {}

bool Relaxation::still() const {
  double mean = 0, square = 0;
  for (const double e : kinetic_) mean += e;
  mean /= static_cast<double>(per_window_);
  for (const double e : kinetic_) square += (e - mean) * (e - mean);
  return std::sqrt(square / static_cast<double>(per_window_)) <= options_.fluctuation * mean;
}

/// Is the kinetic energy of the last samples negligible?
bool Relaxation::negligible(double elastic) const {
  const auto wanted =
      std::max<std::int64_t>(1, std::llround(options_.energy_average * static_cast<double>(per_window_)));
  if (taken_ < wanted) return false;
  double mean = 0;
  for (std::int64_t k = taken_ - wanted; k < taken_; ++k)
    mean += kinetic_[static_cast<std::size_t>(k % per_window_)] / static_cast<double>(wanted);
  return mean < options_.energy * (elastic > 0 ? elastic : first_);
}

void Relaxation::add_sample(double kinetic, double elastic) {
  if (taken_ == 0) first_ = kinetic;
  const bool looked_at_elastic = wants_elastic();
  kinetic_[static_cast<std::size_t>(taken_ % per_window_)] = kinetic;
  ++taken_;
  std::string rest;
  if (kinetic == 0 || (looked_at_elastic && negligible(elastic)))
    rest = relaxed_energy;
  else if (taken_ >= per_window_ && still())
    rest = relaxed_fluctuation;
  (options_.unbalanced > 0 ? at_rest_ : ended_) = rest;
  if (at_rest_.empty()) look_at_budget();
}

void Relaxation::judge_forces(double unbalanced) {
  if (unbalanced <= options_.unbalanced) ended_ = at_rest_;
  at_rest_.clear();
  look_at_budget();
}

void Relaxation::look_at_budget() {
  if (ended_.empty() && static_cast<double>(taken_ - 1) >= options_.windows * static_cast<double>(per_window_))
    ended_ = not_relaxed;
}

std::vector<double> Relaxation::save() const {
  std::vector<double> state{static_cast<double>(taken_), first_};
  state.insert(state.end(), kinetic_.begin(), kinetic_.end());
  return state;
}

void Relaxation::load(const std::vector<double>& state) {
  if (state.size() != 2 + kinetic_.size())
    throw data_error("the checkpoint's relaxation is of another study", {},
                     "delete it; the task then starts from its beginning");
  taken_ = static_cast<std::int64_t>(state[0]);
  first_ = state[1];
  kinetic_.assign(state.begin() + 2, state.end());
}

}  // namespace jam
