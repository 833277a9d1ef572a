#include "write_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "complain.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/report/report.hpp"
#include "jamscape/study/ensemble.hpp"
#include "jamscape/study/ledger.hpp"
#include "jamscape/study/tables.hpp"
#include "jamscape/study/transition_kinds.hpp"
#include "jamscape/study/transitions.hpp"

namespace jam::app {
namespace {

std::string with_error(const Transition& t) {
  if (!std::isfinite(t.value)) {
    const std::string why = why_missing(t);
    return why.substr(0, why.find(':'));  // "no fit"; `jamscape score` and the documentation say why
  }
  return std::isfinite(t.se) ? fmt::format("{:.4f} +- {:.4f}", t.value, t.se) : fmt::format("{:.4f}", t.value);
}

const Transition* find(const std::vector<Transition>& transitions, std::string_view quantity) {
  for (const Transition& t : transitions)
    if (t.quantity == quantity) return &t;
  return nullptr;
}

/// S2's reading of jamming: inflection and contact numbers there.
void print_relaxed(const Study& study, const std::vector<std::vector<Transition>>& transitions, std::size_t width) {
  fmt::print(
      "{:{}}  runs  rho_j (inflection)   Z at rho_j         Z above            without rattlers   rho_p (percolates)\n",
      "system", width);
  for (std::size_t s = 0; s < study.systems.size(); ++s) {
    const auto text = [&](std::string_view quantity) {
      const Transition* t = find(transitions[s], quantity);
      return t ? with_error(*t) : "-";
    };
    const Transition* j = find(transitions[s], "rho_j");
    fmt::print("{:{}}  {:4}  {:19}  {:17}  {:17}  {:17}  {}\n", study.systems[s].name, width, j ? j->n : 0,
               text("rho_j"), text("z_at_rho_j"), text("z_above"), text("z_backbone_above"), text("rho_p"));
  }
}

void print_pressed(const Study& study, const std::vector<std::vector<Transition>>& transitions, std::size_t width) {
  fmt::print("{:{}}  runs  contacts  k of P(f)          peak of P(f)  1st peak of G(r)/L  2nd peak\n", "system", width);
  for (std::size_t s = 0; s < study.systems.size(); ++s) {
    const auto text = [&](const char* name) {
      const Transition* t = find(transitions[s], name);
      return t && std::isfinite(t->value) ? with_error(*t) : std::string("-");
    };
    const Transition *k = find(transitions[s], "tail_k_pooled"), *a = find(transitions[s], "type_a_pooled"),
                     *contacts = find(transitions[s], "force_contacts_pooled");
    fmt::print("{:{}}  {:4}  {:8}  {:17}  {:12}  {:18}  {}\n", study.systems[s].name, width, k ? k->n : 0,
               contacts ? contacts->value : 0, text("tail_k_pooled"),
               !a             ? "-"
               : a->value > 0 ? "yes (type A)"
                              : "no (type B)",
               text("rdf_peak1_pooled"), text("rdf_peak2_pooled"));
  }
}

void print_summary(const Study& study, const std::vector<std::vector<Transition>>& transitions) {
  std::size_t width = 6;
  for (const System& s : study.systems) width = std::max(width, s.name.size());
  if (std::all_of(study.systems.begin(), study.systems.end(),
                  [](const System& s) { return !plans_packing_fraction(s.options); }))
    return print_pressed(study, transitions, width);
  if (std::any_of(transitions.begin(), transitions.end(), [](const auto& of) { return find(of, "rho_j"); }))
    return print_relaxed(study, transitions, width);
  fmt::print("{:{}}  runs  rho_c (mean Z = 3)   rho_c, Z of grains with 2 contacts   inflection of Z\n", "system",
             width);
  for (std::size_t s = 0; s < study.systems.size(); ++s) {
    const Transition *c = find(transitions[s], "rho_c"), *multi = find(transitions[s], "rho_c_multi"),
                     *bend = find(transitions[s], "rho_inflection");
    if (c)
      fmt::print("{:{}}  {:4}  {:19}  {:35}  {}\n", study.systems[s].name, width, c->n, with_error(*c),
                 multi ? with_error(*multi) : "", bend ? with_error(*bend) : "");
    else
      fmt::print("{:{}}  no runs, the measure 'coordination' was not taken, or every state is marked\n",
                 study.systems[s].name, width);
  }
}

void print_json(const Study& study, const std::vector<std::vector<Transition>>& transitions, const std::string& report,
                const Warned& warned) {
  nlohmann::json json{{"event", "summary"}, {"report", report}, {"systems", nlohmann::json::array()}};
  if (relaxes(study)) json["frames_not_relaxed"] = warned.not_relaxed;
  json["frames_marked"] = warned.marked;
  for (std::size_t s = 0; s < study.systems.size(); ++s) {
    nlohmann::json system{{"system", study.systems[s].name}};
    for (const Transition& t : transitions[s])
      system[t.quantity] = {{"n", t.n}, {"value", t.value}, {"se", t.se}};  // not finite becomes null
    json["systems"].push_back(std::move(system));
  }
  fmt::print("{}\n", json.dump());
}

/// One line for each system with marked frames; returns how many there are.
std::size_t warn_of_marked(const Study& study, const std::vector<DoneTask>& done) {
  std::size_t all = 0;
  const auto systems = by_system(study, done);
  for (std::size_t s = 0; s < systems.size(); ++s) {
    const MarkedFrames marked = count_marked(systems[s]);
    all += marked.frames;
    if (marked.frames > 0)
      complain(
          "warning: system '{}': the energy ledger of {} frames of {} of {} runs, from {:.4g} on, is off by more "
          "than {:g} % of what was turned over, at most by {:.3g} %\n",
          study.systems[s].name, marked.frames, marked.runs, systems[s].size(), marked.from,
          100 * study.info.ledger_mark, 100 * marked.worst);
  }
  if (all > 0)
    complain("  they are marked in all tables and {}; integrator.step and integrator.scheme mend it\n",
             study.info.ledger == LedgerRule::open
                 ? "are in the means, which say so in the column `marked` (study.ledger = \"open\")"
                 : "enter no mean");
  return all;
}

}  // namespace

bool name_left_out(const std::vector<LeftOut>& left_out, const Study& study, const std::vector<Task>& tasks) {
  for (const LeftOut& run : left_out) complain("warning: {}\n", describe(run, study, tasks));
  return !left_out.empty();
}

Warned write_results(const Study& study, const std::vector<Task>& tasks, const Written& written, Summary summary) {
  Warned warned;
  warned.damaged = name_left_out(written.left_out, study, tasks);
  const FileLock lock = FileLock::lock(written.to / "lock.tables");  // shards may end at the same moment
  const std::vector<DoneTask> done = find_done(study, tasks, written.places, written.left_out);
  const std::vector<std::string> empty = write_tables(study, done, written.to);
  if (!empty.empty())
    complain(
        "note: no rows in the tables of {}: {}\n", fmt::join(empty, ", "),
        study.measure.rows_every > 0
            ? fmt::format("they are taken at packing fractions that are multiples of measure.rows_every = {}, and no "
                          "frame lies on one; measure.rows_every = 0 takes all",
                          study.measure.rows_every)
            : std::string("no frame has what they count"));
  write_ensemble(study, done, written.to);
  const std::vector<std::vector<Transition>> transitions = write_transitions(study, done, written.to);
  if (name_left_out(write_report(written.to, written.places, written.left_out), study, tasks)) warned.damaged = true;
  const std::string report =
      written.keeps ? std::filesystem::absolute(written.to / "report.html").lexically_normal().string() : "";
  warned.not_relaxed = frames_not_relaxed(done);
  warned.marked = warn_of_marked(study, done);
  if (warned.not_relaxed > 0)
    complain(
        "warning: {} frames are not relaxed: their relaxation ran out of its budget (`budget` in the column "
        "`relaxation`)\n  stage.NAME.relax_windows sets the budget\n",
        warned.not_relaxed);
  if (summary == Summary::json) print_json(study, transitions, report, warned);
  if (summary != Summary::text) return warned;
  if (done.size() < tasks.size())
    fmt::print("{} of {} runs are done; the others are left out\n", done.size(), tasks.size());
  print_summary(study, transitions);
  if (!report.empty()) fmt::print("report: {}\n", report);
  return warned;
}

}  // namespace jam::app
