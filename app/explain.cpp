#include "jamscape/observe/explain.hpp"

#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "jamscape/base/nearest.hpp"
#include "jamscape/observe/measure.hpp"
#include "jamscape/study/study.hpp"
#include "jamscape/study/transition_kinds.hpp"

namespace jam::app {
namespace {

void print_option(const KnownOption& o) {
  fmt::print("{}\n  {}\n  type     {}\n", o.key, o.meta.text, o.type);
  if (!o.meta.unit.empty()) fmt::print("  unit     {}\n", o.meta.unit);
  if (!o.range.empty()) fmt::print("  range    {}\n", o.range);
  fmt::print("  default  {}\n", o.default_value);
  if (!o.meta.source.empty()) fmt::print("  source   {}\n", o.meta.source);
}

ExitCode list_all(const std::vector<KnownOption>& options) {
  fmt::print("Options of a study file:\n");
  for (const KnownOption& o : options) fmt::print("  {:30} {}\n", o.key, o.meta.text);
  fmt::print("\nMeasures:\n");
  for (const Measure& m : measures()) fmt::print("  {:30} {}\n", m.name, m.title);
  fmt::print("\nOf all realisations of a system (ensemble/transitions.csv):\n");
  for (const TransitionKind& t : transition_kinds()) fmt::print("  {:30} {}\n", t.name, t.text);
  return ExitCode::done;
}

/// "stage.compress.speed" is explained by "stage.speed".
std::string general_key(const std::string& key) {
  const std::size_t first = key.find('.'), last = key.rfind('.');
  return key.starts_with("stage.") && first != last ? "stage" + key.substr(last) : key;
}

ExitCode explain(const std::string& key) {
  const std::vector<KnownOption> options = known_options();
  if (key.empty()) return list_all(options);
  std::vector<std::string> known;
  bool found = false;
  for (const KnownOption& o : options) {
    known.push_back(o.key);
    const bool part = o.key.ends_with("." + key) || o.key.starts_with(key + ".");
    if (o.key != general_key(key) && !part) continue;
    if (found) fmt::print("\n");
    print_option(o);
    found = true;
  }
  for (const Measure& m : measures()) {
    known.push_back(m.name);
    for (const ColumnInfo& c : m.columns) known.push_back(c.name);
    bool column = false;
    for (const ColumnInfo& c : m.columns) column = column || c.name == key;
    if (m.name != key && !column) continue;
    if (found) fmt::print("\n");
    fmt::print("{}", jam::explain(m));
    found = true;
  }
  for (const TransitionKind& t : transition_kinds()) {
    known.emplace_back(t.name);
    if (t.name != key) continue;
    if (found) fmt::print("\n");
    fmt::print("{}\n  {}\n  without a value: {}\n  stands in ensemble/transitions.csv\n  source   {}\n", t.name, t.text,
               t.missing, t.source);
    found = true;
  }
  if (found) return ExitCode::done;
  const std::string near = nearest(key, known);
  throw usage_error(fmt::format("nothing is known as '{}'", key), "jamscape explain",
                    near.empty() ? "`jamscape explain` lists everything" : fmt::format("jamscape explain {}", near));
}

}  // namespace

void add_explain(CLI::App& program, Action& action) {
  CLI::App* sub = program.add_subcommand(
      "explain", "What an option, a measure or a transition means: unit, range, formula, source");
  auto key = std::make_shared<std::string>();
  sub->add_option(
      "key", *key,
      "an option (contact.friction), a measure, a column, a transition (rho_c); everything is listed without it");
  sub->callback([key, &action] { action = [key] { return explain(*key); }; });
}

}  // namespace jam::app
