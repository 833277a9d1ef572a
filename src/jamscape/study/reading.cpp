#include "jamscape/study/reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "jamscape/base/border.hpp"
#include "jamscape/base/error.hpp"
#include "jamscape/stats/none.hpp"
#include "jamscape/stats/resampling.hpp"
#include "jamscape/study/averaging.hpp"
#include "jamscape/study/identity.hpp"
#include "jamscape/study/transition_kinds.hpp"

namespace jam {
namespace {

Reading missing(std::string problem) { return {{0, none, none, none}, std::move(problem)}; }

/// The rows of a state as one number, and the abscissa of the largest.
struct Reduced {
  double value = none, at = none;
};

double width(const std::vector<double>& x, const std::vector<double>& weight) {
  double sum = 0, first = 0, second = 0;
  for (std::size_t k = 0; k < x.size(); ++k) sum += weight[k], first += weight[k] * x[k];
  for (std::size_t k = 0; k < x.size(); ++k) second += weight[k] * (x[k] - first / sum) * (x[k] - first / sum);
  return sum > 0 ? std::sqrt(second / sum) : none;
}

Reduced reduce(const Side& side, const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> at, values;
  for (std::size_t k = 0; k < y.size(); ++k) {
    const bool inside =
        x.empty() || side.over.size() != 2 || (reaches(x[k], side.over[0]) && !exceeds(x[k], side.over[1]));
    if (inside && std::isfinite(y[k])) at.push_back(x.empty() ? 0 : x[k]), values.push_back(y[k]);
  }
  if (values.empty()) return {};
  auto largest = values.begin();  // of equal ones the first, whatever their last digits
  for (auto v = values.begin(); v != values.end(); ++v)
    if (exceeds(*v, *largest)) largest = v;
  const double where = at[static_cast<std::size_t>(largest - values.begin())];
  switch (side.reduce) {
    case Reduce::max:
    case Reduce::argmax:
      return {*largest, where};
    case Reduce::min:
      return {*std::min_element(values.begin(), values.end()), where};
    case Reduce::sd:
      return {moments(values).sd, where};
    case Reduce::width:
      return {width(at, values), where};
    case Reduce::mean:
      break;
  }
  return {moments(values).mean, where};
}

}  // namespace

Reader::Reader(const Study& study, const std::vector<DoneTask>& done)
    : study_(study),
      measures_(measured(study, done)),
      done_(by_system(study, done)),
      series_(study.systems.size()),
      transitions_(study.systems.size()) {}

Reading Reader::read(const Side& side, std::size_t system) {
  if (side.quantity.empty()) return {{std::numeric_limits<std::size_t>::max(), side.value, 0, 0}, {}};
  if (done_[system].empty()) return missing("no runs");
  for (const Transition& t : transitions(system))
    if (t.quantity == side.quantity) return {{t.n, t.value, none, t.se}, std::isfinite(t.value) ? "" : why_missing(t)};
  return side.quantity.find('.') == std::string::npos ? read_column(side, system) : read_rows(side, system);
}

const FrameSeries& Reader::series(std::size_t s) {
  if (!series_[s]) series_[s] = read_frame_series(done_[s], measures_);
  return *series_[s];
}

const std::vector<Transition>& Reader::transitions(std::size_t s) {
  if (!transitions_[s]) transitions_[s] = find_transitions(study_, s, done_[s], measures_, series(s));
  return *transitions_[s];
}

Reading Reader::read_column(const Side& side, std::size_t system) {
  const FrameSeries& s = series(system);
  const auto* column = s.find(side.quantity);
  if (!column || s.target.empty()) return missing(fmt::format("'{}' was not measured", side.quantity));
  std::vector<Run> runs;
  for (const std::vector<double>& values : *column) {
    runs.emplace_back();
    for (const std::size_t f : s.states()) runs.back().push_back({s.target[f], {}, {values[f]}});
  }
  const auto q =
      static_cast<std::size_t>(std::find(s.quantity.begin(), s.quantity.end(), side.quantity) - s.quantity.begin());
  return sample(side, system, runs, s.averaging[q]);
}

Reading Reader::read_rows(const Side& side, std::size_t system) {
  const std::size_t dot = side.quantity.find('.');
  const std::string name = side.quantity.substr(0, dot), wanted = side.quantity.substr(dot + 1);
  const Measure& measure = find_measure(name);
  const auto column = [&](const std::string& of) {
    std::size_t c = 0;
    while (c < measure.columns.size() && measure.columns[c].name != of) ++c;
    return c;
  };
  const auto ratio = std::find_if(measure.ratios.begin(), measure.ratios.end(),
                                  [&](const PooledRatio& r) { return r.name == wanted; });
  const std::size_t c = column(wanted);
  if (ratio == measure.ratios.end() && c == measure.columns.size())
    throw usage_error(fmt::format("'{}' has no column '{}'", name, wanted), "targets",
                      fmt::format("jamscape explain {}", name));
  if (std::find(measures_.begin(), measures_.end(), &measure) == measures_.end())
    return missing(fmt::format("'{}' was not measured", name));
  if (ratio != measure.ratios.end())
    return pooled(side, system, runs_of(measure, column(ratio->over), system),
                  runs_of(measure, column(ratio->under), system));
  return sample(side, system, runs_of(measure, c, system), measure.columns[c].averaging);
}

/// Frames without rows are no states: a measure may be taken at some packing fractions only.
std::vector<Reader::Run> Reader::runs_of(const Measure& measure, std::size_t column, std::size_t system) {
  const auto [at, first] = rows_.try_emplace({&measure, system});
  if (first)
    for (const DoneTask* d : done_[system]) at->second.push_back(read_frame_rows(*d, measure));
  const std::vector<std::size_t> states = series(system).states();
  std::vector<Run> runs;
  for (std::size_t r = 0; r < at->second.size(); ++r) {
    runs.emplace_back();
    for (const std::size_t f : states) {
      State state{done_[system][r]->frames[f].packing_fraction, {}, {}};
      for (const std::vector<double>& row : at->second[r][f]) state.x.push_back(row[0]), state.y.push_back(row[column]);
      if (!state.x.empty() && !done_[system][r]->left_out[f]) runs.back().push_back(std::move(state));
    }
  }
  return runs;
}

double Reader::fraction(const StateName& name, std::size_t system, const Run& run) {
  if (run.empty()) return none;
  if (name.kind == StateName::Kind::first) return run.front().packing_fraction;
  if (name.kind == StateName::Kind::last) return run.back().packing_fraction;
  if (name.transition.empty()) return name.offset;
  for (const Transition& t : transitions(system))
    if (t.quantity == name.transition) return t.value + name.offset;
  return none;
}

double Reader::near(const Side& side, std::size_t system, const Run& run, const StateName& name) {
  const double at = fraction(name, system, run);
  if (!std::isfinite(at) || run.empty()) return none;
  // A curve says nothing about what lies more than a state beyond its ends.
  const double first = run.front().packing_fraction, last = run.back().packing_fraction;
  const double below = run.size() > 1 ? run[1].packing_fraction - first : 0,
               above = run.size() > 1 ? last - run[run.size() - 2].packing_fraction : 0;
  if (at < first - below - 1e-9 || at > last + above + 1e-9) return none;
  const auto distance = [at](const State& s) { return std::abs(s.packing_fraction - at); };
  const auto state = std::min_element(run.begin(), run.end(),
                                      [&](const State& a, const State& b) { return distance(a) < distance(b); });
  const Reduced r = reduce(side, state->x, state->y);
  return side.reduce == Reduce::argmax ? r.at : r.value;
}

double Reader::take(const Side& side, std::size_t system, const Run& run) {
  const StateName at = read_state(side.at, "targets");
  double value = none;
  if (at.kind < StateName::Kind::max) {
    value = near(side, system, run, at);
  } else {
    double lo = -std::numeric_limits<double>::infinity(), hi = -lo;
    if (side.between.size() == 2)
      lo = fraction(read_state(side.between[0], "targets"), system, run) - 1e-9,
      hi = fraction(read_state(side.between[1], "targets"), system, run) + 1e-9;
    std::vector<Reduced> states;
    for (const State& s : run)
      if (s.packing_fraction >= lo && s.packing_fraction <= hi)
        if (const Reduced r = reduce(side, s.x, s.y); std::isfinite(r.value)) states.push_back(r);
    if (states.empty()) return none;
    const bool least = at.kind == StateName::Kind::min;
    Reduced chosen = states.front();
    for (const Reduced& s : states)
      if (least ? exceeds(chosen.value, s.value) : exceeds(s.value, chosen.value)) chosen = s;
    value = side.reduce == Reduce::argmax ? chosen.at : chosen.value;
    if (at.kind == StateName::Kind::mean) {
      value = 0;
      for (const Reduced& r : states)
        value += (side.reduce == Reduce::argmax ? r.at : r.value) / static_cast<double>(states.size());
    }
  }
  if (!side.minus.empty()) value -= near(side, system, run, read_state(side.minus, "targets"));
  return side.per_grain ? value / static_cast<double>(study_.systems[system].options.grains.count) : value;
}

Reading Reader::sample(const Side& side, std::size_t system, const std::vector<Run>& runs, Averaging averaging) {
  std::vector<double> values;
  for (const Run& run : runs) values.push_back(take(side, system, run));
  const bool one_state = read_state(side.at, "targets").kind < StateName::Kind::max && side.minus.empty();
  const Moments m = average(std::move(values), one_state ? averaging : Averaging::mean);
  return {m, m.n == 0 ? fmt::format("no value at {}", side.at) : ""};
}

Reading Reader::pooled(const Side& side, std::size_t system, const std::vector<Run>& over,
                       const std::vector<Run>& under) {
  const Estimate e = jackknife(over.size(), [&](std::span<const std::size_t> which) {
    std::map<double, std::map<double, std::pair<double, double>>> sums;  // by packing fraction and abscissa
    for (const std::size_t r : which)
      for (std::size_t s = 0; s < over[r].size(); ++s)
        for (std::size_t k = 0; k < over[r][s].y.size(); ++k) {
          auto& sum = sums[over[r][s].packing_fraction][over[r][s].x[k]];
          sum.first += over[r][s].y[k], sum.second += under[r][s].y[k];
        }
    Run run;
    for (const auto& [rho, rows] : sums) {
      run.push_back({rho, {}, {}});
      for (const auto& [x, sum] : rows)
        run.back().x.push_back(x), run.back().y.push_back(sum.second == 0 ? none : sum.first / sum.second);
    }
    return take(side, system, run);
  });
  return {{e.n, e.value, none, e.error}, std::isfinite(e.value) ? "" : fmt::format("no value at {}", side.at)};
}

}  // namespace jam
