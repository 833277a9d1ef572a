#include "jamscape/study/score.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "jamscape/stats/none.hpp"
#include "jamscape/stats/sign_test.hpp"
#include "jamscape/study/reading.hpp"

namespace jam {
namespace {

bool same_value(const Option& option, const Written& wanted) {
  const std::string value = print_value(option);
  if (const auto* number = std::get_if<double*>(&option.target)) {
    if (const auto* x = std::get_if<double>(&wanted.value)) return std::abs(**number - *x) < 1e-12;
    if (const auto* n = std::get_if<std::int64_t>(&wanted.value)) return **number == static_cast<double>(*n);
    return false;
  }
  if (const auto* s = std::get_if<std::string>(&wanted.value)) return value == print_text(*s);
  if (const auto* n = std::get_if<std::int64_t>(&wanted.value)) return value == fmt::format("{}", *n);
  return false;
}

bool fits(const System& system, const Side& side) {
  SystemOptions options = system.options;
  const std::vector<Option> list = system_options(options);
  return std::all_of(side.where.begin(), side.where.end(), [&](const auto& condition) {
    return std::any_of(list.begin(), list.end(),
                       [&](const Option& o) { return o.key == condition.first && same_value(o, condition.second); });
  });
}

std::string print_side(const Side& side) {
  if (side.quantity.empty()) return fmt::format("{}", side.value);
  std::string text = side.quantity + (side.per_grain ? "/N" : "");
  if (!side.at.empty()) text += fmt::format(" at {}", side.at);
  if (side.between.size() == 2) text += fmt::format(" of {} to {}", side.between[0], side.between[1]);
  if (!side.minus.empty()) text += fmt::format(" minus at {}", side.minus);
  return text;
}

Score judge(const Target& target, const Reading& left, const Reading& right, std::string systems) {
  Score score{target.name,
              target.source,
              std::move(systems),
              {},
              none,
              none,
              std::min(left.moments.n, right.moments.n),
              target.realisations,
              Verdict::insufficient,
              {}};
  bool agrees = false;
  if (target.is_value()) {
    score.published = fmt::format("{} +- {}", target.right.value, target.tolerance);
    score.ours = left.moments.mean, score.error = left.moments.se;
    agrees = std::abs(score.ours - target.right.value) <= target.tolerance;
  } else {
    const Difference d = difference(left.moments, right.moments);
    score.ours = d.value, score.error = d.error;
    score.published = target.is_order() ? fmt::format("{} > {}", print_side(target.left), print_side(target.right))
                                        : fmt::format("{} = {} +- {}", print_side(target.left),
                                                      print_side(target.right), target.tolerance);
    agrees = target.is_order() ? sign_test(left.moments, right.moments) == Sign::above
                               : std::abs(d.value) <= target.tolerance;
  }
  score.note = !left.problem.empty() ? left.problem : right.problem;
  const bool enough = score.note.empty() && score.n >= static_cast<std::size_t>(target.realisations);
  if (!enough) {
    if (score.note.empty())
      score.note = !target.is_order() || std::isfinite(score.error)
                       ? fmt::format("{} so far", agrees ? "agrees" : "does not agree")
                       : "one run has no error";
  } else if (!target.known_deviation.empty()) {
    score.verdict = Verdict::known_deviation;
    score.note = target.known_deviation;
  } else {
    score.verdict = agrees ? Verdict::pass : Verdict::fail;
  }
  return score;
}

}  // namespace

std::string_view verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::fail:
      return "fail";
    case Verdict::known_deviation:
      return "known deviation";
    case Verdict::insufficient:
      return "insufficient";
  }
  return "";
}

bool concerns(const Target& target, const Study& study) {
  const auto some = [&](const Side& side) {
    return std::any_of(study.systems.begin(), study.systems.end(), [&](const System& s) { return fits(s, side); });
  };
  return some(target.left) && some(target.right);
}

std::vector<Score> score_targets(const std::vector<Target>& targets, const Study& study,
                                 const std::vector<DoneTask>& done) {
  Reader reader(study, done);
  std::vector<bool> takes_marked(study.systems.size(), false);
  for (const DoneTask& d : done)
    for (std::size_t f = 0; f < d.marked.size(); ++f)
      if (d.marked[f] && !d.left_out[f]) takes_marked[d.task->system] = true;
  std::vector<Score> scores;
  for (const Target& target : targets) {
    for (std::size_t a = 0; a < study.systems.size(); ++a) {
      if (!fits(study.systems[a], target.left)) continue;
      const bool two = !target.right.quantity.empty() && !target.right.where.empty();
      for (std::size_t b = 0; b < study.systems.size(); ++b) {
        if (two ? !fits(study.systems[b], target.right) : a != b) continue;
        const std::string systems =
            two ? fmt::format("{} {} {}", study.systems[a].name, target.is_order() ? ">" : "=", study.systems[b].name)
                : study.systems[a].name;
        scores.push_back(judge(target, reader.read(target.left, a), reader.read(target.right, b), systems));
        if (takes_marked[a] || takes_marked[b]) {
          std::string& note = scores.back().note;
          note += std::string(note.empty() ? "" : "; ") + "marked frames taken in";
        }
      }
    }
  }
  return scores;
}

}  // namespace jam
