#include "write_results.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "jamscape/base/files.hpp"
#include "jamscape/report/report.hpp"
#include "jamscape/study/ensemble.hpp"
#include "jamscape/study/tables.hpp"
#include "jamscape/study/transitions.hpp"

namespace jam::app {
namespace {

std::string with_error(const Transition& t) {
  if (!std::isfinite(t.value)) return "not reached";
  return std::isfinite(t.se) ? fmt::format("{:.4f} +- {:.4f}", t.value, t.se) : fmt::format("{:.4f}", t.value);
}

const Transition* find(const std::vector<Transition>& transitions, std::string_view quantity) {
  for (const Transition& t : transitions)
    if (t.quantity == quantity) return &t;
  return nullptr;
}

void print_summary(const Study& study, const std::vector<std::vector<Transition>>& transitions) {
  std::size_t width = 6;
  for (const System& s : study.systems) width = std::max(width, s.name.size());
  fmt::print("{:{}}  runs  rho_c (mean Z = 3)   rho_c, Z of grains with 2 contacts   inflection of Z\n", "system",
             width);
  for (std::size_t s = 0; s < study.systems.size(); ++s) {
    const Transition *c = find(transitions[s], "rho_c"), *multi = find(transitions[s], "rho_c_multi"),
                     *bend = find(transitions[s], "rho_inflection");
    if (c)
      fmt::print("{:{}}  {:4}  {:19}  {:35}  {}\n", study.systems[s].name, width, c->n, with_error(*c),
                 multi ? with_error(*multi) : "", bend ? with_error(*bend) : "");
    else
      fmt::print("{:{}}  no runs, or the measure 'coordination' was not taken\n", study.systems[s].name, width);
  }
}

void print_json(const Study& study, const std::vector<std::vector<Transition>>& transitions,
                const std::string& report) {
  nlohmann::json json{{"event", "summary"}, {"report", report}, {"systems", nlohmann::json::array()}};
  for (std::size_t s = 0; s < study.systems.size(); ++s) {
    nlohmann::json system{{"system", study.systems[s].name}};
    for (const Transition& t : transitions[s])
      system[t.quantity] = {{"n", t.n}, {"value", t.value}, {"se", t.se}};  // not finite becomes null
    json["systems"].push_back(std::move(system));
  }
  fmt::print("{}\n", json.dump());
}

}  // namespace

void write_results(const Study& study, const std::vector<Task>& tasks, const std::filesystem::path& results,
                   Summary summary) {
  const FileLock lock = FileLock::lock(results / "lock.tables");  // shards may end at the same moment
  const std::vector<DoneTask> done = find_done(tasks, results, chosen_measures(study));
  write_tables(study, done, results);
  write_ensemble(study, done, results);
  const std::vector<std::vector<Transition>> transitions = write_transitions(study, done, results);
  write_report(results);
  const std::string report = std::filesystem::absolute(results / "report.html").lexically_normal().string();
  if (summary == Summary::json) print_json(study, transitions, report);
  if (summary != Summary::text) return;
  if (done.size() < tasks.size())
    fmt::print("{} of {} runs are done; the others are left out\n", done.size(), tasks.size());
  print_summary(study, transitions);
  fmt::print("report: {}\n", report);
}

}  // namespace jam::app
