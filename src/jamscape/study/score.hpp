// Published values beside ours: one row per target and system.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "jamscape/study/done_tasks.hpp"
#include "jamscape/study/study.hpp"
#include "jamscape/study/targets.hpp"

namespace jam {

enum class Verdict { pass, fail, known_deviation, insufficient };
std::string_view verdict_name(Verdict verdict);

struct Score {
  std::string target, source;
  std::string systems;    ///< "a", or "a > b"
  std::string published;  ///< "0.814 +- 0.004", or "left > right", or "left = right +- 0.02"
  double ours = 0;        ///< the value, or left minus right; NaN where there is none
  double error = 0;       ///< its standard error; NaN where it cannot be estimated
  std::size_t n = 0;      ///< realisations behind it, of the side that has fewer
  std::int64_t needed = 0;
  Verdict verdict = Verdict::insufficient;
  std::string note;  ///< reason of a known deviation, or what is missing
};

/// Does the study have systems of both sides?
bool concerns(const Target& target, const Study& study);

/// One row for each target that concerns the study and each system (or two) it is of. A value or an agreement passes
/// within its tolerance; an order when left exceeds right by more than two standard errors. Fewer realisations than
/// needed: insufficient. A known deviation is never a pass. `done` have been measured.
std::vector<Score> score_targets(const std::vector<Target>& targets, const Study& study,
                                 const std::vector<DoneTask>& done);

}  // namespace jam
