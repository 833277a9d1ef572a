// What one side of a target reads off the results of a system: a transition, or a number from the curves of its
// realisations.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jamscape/stats/moments.hpp"
#include "jamscape/study/done_tasks.hpp"
#include "jamscape/study/study.hpp"
#include "jamscape/study/targets.hpp"
#include "jamscape/study/transitions.hpp"

namespace jam {

/// A sample over realisations, or a value with an error of its own (a transition, a pooled ratio); or why there is
/// none.
struct Reading {
  Moments moments;
  std::string problem;
};

class Reader {
 public:
  Reader(const Study& study, const std::vector<DoneTask>& done);
  /// Throws a usage error for a side that no study could have.
  Reading read(const Side& side, std::size_t system);

 private:
  /// The rows of one state: abscissae (none for a column of frames.csv) and values.
  struct State {
    double packing_fraction = 0;
    std::vector<double> x, y;
  };
  using Run = std::vector<State>;

  Reading read_column(const Side& side, std::size_t system);
  Reading read_rows(const Side& side, std::size_t system);
  Reading sample(const Side& side, std::size_t system, const std::vector<Run>& runs, Averaging averaging);
  Reading pooled(const Side& side, std::size_t system, const std::vector<Run>& over, const std::vector<Run>& under);

  /// The number a side takes from a curve; NaN where it has none.
  double take(const Side& side, std::size_t system, const Run& run);
  double near(const Side& side, std::size_t system, const Run& run, const StateName& name);
  /// The packing fraction of a state; NaN where its transition is not known.
  double fraction(const StateName& name, std::size_t system, const Run& run);

  std::vector<Run> runs_of(const Measure& measure, std::size_t column, std::size_t system);
  const FrameSeries& series(std::size_t system);
  const std::vector<Transition>& transitions(std::size_t system);

  const Study& study_;
  std::vector<const Measure*> measures_;
  std::vector<std::vector<const DoneTask*>> done_;
  std::vector<std::optional<FrameSeries>> series_;
  std::vector<std::optional<std::vector<Transition>>> transitions_;
  std::map<std::pair<const Measure*, std::size_t>, std::vector<FrameRows>> rows_;
};

}  // namespace jam
