// How a run is shown while it goes: a bar on a terminal, plain lines in a file or a pipe, lines of JSON for programs, or
// nothing.
#pragma once

#include <chrono>
#include <cstdio>
#include <deque>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "jamscape/study/run.hpp"
#include "jamscape/study/study.hpp"

namespace jam::app {

enum class Show { bar, lines, json, nothing };

class Monitor : public RunListener {
 public:
  /// `mine` are the tasks of this runner; `out` is where it is shown.
  Monitor(const Study& study, const std::vector<Task>& tasks, const std::vector<std::size_t>& mine, Show show,
          std::FILE* out);
  ~Monitor() override;

  void started(std::size_t task, bool resumed) override;
  void progress(std::size_t task, const Progress& progress) override;
  void measuring(std::size_t task) override;
  void warned(std::size_t task, const std::string& reason) override;
  void finished(std::size_t task, bool simulated) override;
  void failed(std::size_t task, const std::string& reason) override;
  void skipped(std::size_t task) override;
  void tick() override;

 private:
  enum class Phase { waiting, simulating, measuring, ended };
  struct State {
    Phase phase = Phase::waiting;
    std::int64_t step = 0;  ///< the last one seen
    std::int64_t steps =
        0;  ///< of the whole run, as far as is known: the plan guesses how long grains settle and relax
    std::int64_t found = 0;  ///< those that were there when it started
    double packing_fraction = 0;
    bool seen = false;
    bool resumed = false;
  };
  struct Totals {
    double cost = 0, behind = 0, gained = 0;  ///< grain-steps
    std::size_t ended = 0, running = 0, tasks = 0;
    double lowest = 0, highest = 0;  ///< packing fractions of running tasks
    double rate = 0, seconds_left = -1;

    double fraction() const { return cost > 0 ? behind / cost : 1; }
  };

  Totals totals();
  std::string name(std::size_t task) const;
  void event(std::size_t task, const char* what, const std::string& reason = {});
  /// A reader who is gone ends the showing, not the run.
  void put(const std::string& text);
  void line(const std::string& text);
  std::vector<std::string> notes(const Totals& t) const;
  void draw_bar(const Totals& t);
  void print_line(const Totals& t);
  void print_json(const Totals& t);

  const Study& study_;
  const std::vector<Task>& tasks_;
  std::vector<std::size_t> mine_;
  Show show_;
  std::FILE* out_;
  std::mutex mutex_;
  std::vector<State> states_;
  std::size_t failures_ = 0;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::deque<std::pair<double, double>> samples_;  ///< seconds, grain-steps gained by then
  double last_line_ = -1e9;     ///< seconds, of the last line of progress
  double last_fraction_ = -1;  ///< and how far the run was then
  bool bar_drawn_ = false;
};

}  // namespace jam::app
