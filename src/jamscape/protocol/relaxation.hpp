// Has a packing come to rest? Watches the energies of a relaxation and says when, and why, it ends.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jamscape/protocol/options.hpp"

namespace jam {

/// What ends a relaxation, in Packing::relaxation and in tables.
inline constexpr const char* relaxed_fluctuation = "fluctuation";  ///< S2's criterion: std(E_kin) <= f mean(E_kin)
inline constexpr const char* relaxed_energy = "energy";            ///< E_kin is negligible
inline constexpr const char* not_relaxed = "budget";               ///< neither came about within the windows allowed

class Relaxation {
 public:
  explicit Relaxation(const RelaxOptions& options = {});

  /// Steps after the beginning at which the next sample is due.
  std::int64_t next_sample() const { return (taken_ + 1) * interval_; }
  /// The elastic energy is not looked at with every sample, because it costs a pass over all contacts.
  bool wants_elastic() const { return taken_ % 10 == 0; }
  void add_sample(double kinetic, double elastic);

  /// True after a sample that is at rest by its kinetic energy, where the forces are to be judged too: then
  /// judge_forces() follows before the next sample.
  bool wants_forces() const { return !at_rest_.empty(); }
  /// `unbalanced` is that of unbalanced.hpp.
  void judge_forces(double unbalanced);

  /// Empty while it goes on.
  const std::string& ended() const { return ended_; }

  std::vector<double> save() const;
  void load(const std::vector<double>& state);

 private:
  bool still() const;
  bool negligible(double elastic) const;
  void look_at_budget();

  RelaxOptions options_;
  std::int64_t interval_, per_window_;  ///< steps between samples; samples in a window
  std::int64_t taken_ = 0;
  double first_ = 0;             ///< kinetic energy of the first sample
  std::vector<double> kinetic_;  ///< the last window's samples, sample k at k mod per_window_
  std::string ended_;
  std::string at_rest_;  ///< why, where the forces are still to be judged
};

}  // namespace jam
