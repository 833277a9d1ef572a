#include "jamscape/study/score.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "jamscape/base/error.hpp"
#include "jamscape/stats/moments.hpp"
#include "jamscape/stats/sign_test.hpp"
#include "jamscape/study/identity.hpp"
#include "jamscape/study/transitions.hpp"

namespace jam {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

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

/// A sample, or a value with an error of its own (a transition of the mean curve).
struct Reading {
  Moments moments;
  std::string problem;
};

Reading missing(std::string problem) { return {{0, none, none, none}, std::move(problem)}; }

class Scorer {
 public:
  Scorer(const Study& study, const std::vector<DoneTask>& done)
      : study_(study),
        measures_(chosen_measures(study)),
        done_(by_system(study, done)),
        series_(study.systems.size()),
        transitions_(study.systems.size()) {}

  Reading read(const Side& side, std::size_t system) {
    if (side.quantity.empty()) return {{std::numeric_limits<std::size_t>::max(), side.value, 0, 0}, {}};
    if (done_[system].empty()) return missing("no runs");
    for (const Transition& t : transitions(system))
      if (t.quantity == side.quantity) return {{t.n, t.value, none, t.se}, {}};
    const std::size_t dot = side.quantity.find('.');
    return dot == std::string::npos ? read_column(side, system) : read_rows(side, system, dot);
  }

 private:
  const FrameSeries& series(std::size_t s) {
    if (!series_[s]) series_[s] = read_frame_series(done_[s], measures_);
    return *series_[s];
  }

  const std::vector<Transition>& transitions(std::size_t s) {
    if (!transitions_[s])
      transitions_[s] = find_transitions(series(s), static_cast<std::uint64_t>(study_.info.seed),
                                         physics_key(study_.systems[s].options));
    return *transitions_[s];
  }

  /// The packing fraction an `at` means; nothing when rho_c is not known.
  std::optional<double> fraction(const std::string& at, std::size_t system) {
    double base = 0;
    std::string_view rest = at;
    if (rest.starts_with("rho_c")) {
      for (const Transition& t : transitions(system))
        if (t.quantity == "rho_c") base = t.value;
      rest.remove_prefix(5);
      if (rest.empty()) return std::isfinite(base) ? std::optional(base) : std::nullopt;
      if (rest.front() == '+') rest.remove_prefix(1);
    }
    double offset = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), offset);
    if (error != std::errc{} || end != rest.data() + rest.size())
      throw usage_error(fmt::format("'{}' is no packing fraction", at), "targets",
                        "a number, max, min, rho_c or rho_c+0.02");
    if (!std::isfinite(base)) return std::nullopt;
    return base + offset;
  }

  double scale(const Side& side, std::size_t system) const {
    return side.per_grain ? 1 / static_cast<double>(study_.systems[system].options.grains.count) : 1;
  }

  Reading read_column(const Side& side, std::size_t system) {
    const FrameSeries& s = series(system);
    const auto* runs = s.find(side.quantity);
    if (!runs || s.target.empty()) return missing(fmt::format("'{}' was not measured", side.quantity));
    std::vector<double> values;
    if (side.at == "max" || side.at == "min") {
      for (const std::vector<double>& run : *runs)
        values.push_back(side.at == "max" ? *std::max_element(run.begin(), run.end())
                                          : *std::min_element(run.begin(), run.end()));
    } else {
      const std::optional<double> at = fraction(side.at, system);
      if (!at) return missing("rho_c is not reached");
      const std::size_t f = nearest_frame(s.target, *at);
      for (const std::vector<double>& run : *runs) values.push_back(run[f]);
    }
    for (double& v : values) v *= scale(side, system);
    return {moments(values), {}};
  }

  static std::size_t nearest_frame(const std::vector<double>& targets, double at) {
    std::size_t best = 0;
    for (std::size_t f = 1; f < targets.size(); ++f)
      if (std::abs(targets[f] - at) < std::abs(targets[best] - at)) best = f;
    return best;
  }

  Reading read_rows(const Side& side, std::size_t system, std::size_t dot) {
    const std::string name = side.quantity.substr(0, dot), column = side.quantity.substr(dot + 1);
    const auto measure =
        std::find_if(measures_.begin(), measures_.end(), [&](const Measure* m) { return m->name == name; });
    if (measure == measures_.end()) return missing(fmt::format("'{}' was not measured", name));
    std::size_t c = 0;
    while (c < (*measure)->columns.size() && (*measure)->columns[c].name != column) ++c;
    if (c == (*measure)->columns.size())
      throw usage_error(fmt::format("'{}' has no column '{}'", name, column), "targets");
    const std::optional<double> at = fraction(side.at, system);
    if (!at) return missing("rho_c is not reached");
    std::vector<double> values;
    for (const DoneTask* d : done_[system]) {
      const FrameRows rows = read_frame_rows(*d, **measure);
      std::vector<double> targets;  // frames without rows are no candidates
      std::vector<std::size_t> frames;
      for (std::size_t f = 0; f < rows.size(); ++f)
        if (!rows[f].empty()) targets.push_back(d->task->plan.frames[f].packing_fraction), frames.push_back(f);
      if (frames.empty()) continue;
      std::vector<double> inside;
      for (const std::vector<double>& row : rows[frames[nearest_frame(targets, *at)]])
        if (side.over.size() != 2 || (row[0] >= side.over[0] && row[0] <= side.over[1])) inside.push_back(row[c]);
      if (inside.empty()) continue;
      const double value = side.reduce == "max"  ? *std::max_element(inside.begin(), inside.end())
                           : side.reduce == "sd" ? moments(inside).sd
                                                 : moments(inside).mean;
      values.push_back(value * scale(side, system));
    }
    return {moments(values), {}};
  }

  const Study& study_;
  std::vector<const Measure*> measures_;
  std::vector<std::vector<const DoneTask*>> done_;
  std::vector<std::optional<FrameSeries>> series_;
  std::vector<std::optional<std::vector<Transition>>> transitions_;
};

std::string print_side(const Side& side) {
  if (side.quantity.empty()) return fmt::format("{}", side.value);
  return side.quantity + (side.per_grain ? "/N" : "") + (side.at.empty() ? "" : fmt::format(" at {}", side.at));
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
    score.published = fmt::format("{} > {}", print_side(target.left), print_side(target.right));
    score.ours = d.value, score.error = d.error;
    agrees = sign_test(left.moments, right.moments) == Sign::above;
  }
  score.note = !left.problem.empty() ? left.problem : right.problem;
  const bool enough = score.note.empty() && score.n >= static_cast<std::size_t>(target.realisations);
  if (!enough) {
    if (score.note.empty())
      score.note = target.is_value() || std::isfinite(score.error)
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

std::vector<Score> score_targets(const std::vector<Target>& targets, const Study& study,
                                 const std::vector<DoneTask>& done) {
  Scorer scorer(study, done);
  std::vector<Score> scores;
  for (const Target& target : targets) {
    bool found = false;
    for (std::size_t a = 0; a < study.systems.size(); ++a) {
      if (!fits(study.systems[a], target.left)) continue;
      const bool two = !target.right.quantity.empty() && !target.right.where.empty();
      for (std::size_t b = 0; b < study.systems.size(); ++b) {
        if (two ? !fits(study.systems[b], target.right) : a != b) continue;
        const std::string systems =
            two ? fmt::format("{} > {}", study.systems[a].name, study.systems[b].name) : study.systems[a].name;
        scores.push_back(judge(target, scorer.read(target.left, a), scorer.read(target.right, b), systems));
        found = true;
      }
    }
    if (!found) scores.push_back(judge(target, missing("no system of this study"), missing(""), "-"));
  }
  return scores;
}

}  // namespace jam
