#include "jamscape/study/targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "jamscape/base/error.hpp"
#include "jamscape/study/study.hpp"
#include "jamscape/study/toml_leaves.hpp"
#include "jamscape/study/transition_kinds.hpp"

namespace jam {
namespace {

std::vector<std::string> system_keys() {
  std::vector<std::string> keys;
  for (const KnownOption& o : known_options())
    if (!o.key.starts_with("study.") && !o.key.starts_with("measure.") && !o.key.starts_with("report."))
      keys.push_back(o.key);
  return keys;
}

void add_condition(Side& side, const std::string& key, const Leaf& leaf) {
  const std::vector<std::string> keys = system_keys();
  const bool of_stage = key.starts_with("stage.");  // named by the study, not known here
  if (!of_stage && std::find(keys.begin(), keys.end(), key) == keys.end()) throw_unknown_key(key, keys, leaf.place);
  side.where.emplace_back(key, leaf.value);
}

/// `at`, `minus` and `between` are understood here, where their place is known.
void check_states(const Leaf& leaf) {
  const std::string name = leaf.key.substr(leaf.key.rfind('.') + 1);
  if (name != "at" && name != "minus" && name != "between") return;
  if (const auto* text = std::get_if<std::string>(&leaf.value.value)) read_state(*text, leaf.value.place);
  const auto* list = std::get_if<std::vector<Written>>(&leaf.value.value);
  if (list && list->size() != 2)
    throw usage_error("'between' needs two states, the first and the last", leaf.value.place,
                      "between = [\"rho_j-0.04\", \"rho_j+0.04\"]");
  if (list)
    for (const Written& item : *list)
      if (const auto* text = std::get_if<std::string>(&item.value))
        if (const StateName s = read_state(*text, item.place); s.kind >= StateName::Kind::max)
          throw usage_error(fmt::format("'{}' is no single state", *text), item.place, "rho_j-0.04, first, last, 0.8");
}

Target read_target(const toml::table& table, const std::string& file) {
  Target t;
  std::vector<Option> options = {{"name", {.text = "what is compared"}, &t.name},
                                 {"source", {.text = "paper and place"}, &t.source},
                                 {"known_deviation", {.text = "why it is not expected to agree"}, &t.known_deviation},
                                 {"realisations", {.text = "needed for a verdict", .min = 1}, &t.realisations},
                                 {"tolerance", {.text = "largest difference that passes", .min = 0}, &t.tolerance},
                                 {"quantity", {.text = "of a value: what is compared"}, &t.left.quantity},
                                 {"value", {.text = "of a value: as published"}, &t.right.value}};
  for (Option& o : options_of(t.left, "left.")) options.push_back(std::move(o));
  for (Option& o : options_of(t.right, "right.")) options.push_back(std::move(o));
  for (const Leaf& leaf : leaves_of(table, "", file)) {
    if (leaf.key.starts_with("where."))
      add_condition(t.left, leaf.key.substr(6), leaf);
    else if (leaf.key.starts_with("left.where."))
      add_condition(t.left, leaf.key.substr(11), leaf);
    else if (leaf.key.starts_with("right.where."))
      add_condition(t.right, leaf.key.substr(12), leaf);
    else
      assign(find_option(options, leaf), leaf.value), check_states(leaf);
  }
  const std::string place = place_of(file, table.source().begin);
  if (t.name.empty()) throw usage_error("a target has no name", place);
  const auto nothing = [](const Side& side) { return side.quantity.empty() && std::isnan(side.value); };
  if (nothing(t.left) || (t.left.quantity.empty() && t.right.quantity.empty()))
    throw usage_error(fmt::format("the target '{}' has no quantity", t.name), place);
  if (nothing(t.right)) throw usage_error(fmt::format("the target '{}' has nothing to compare with", t.name), place);
  for (const Side* side : {&t.left, &t.right})
    if (side->quantity.find('.') != std::string::npos && side->at.empty())
      throw usage_error(fmt::format("the target '{}' does not say at which state '{}' is read", t.name, side->quantity),
                        place, "at = \"last\"");
  return t;
}

}  // namespace

StateName read_state(std::string_view text, const std::string& place) {
  using Kind = StateName::Kind;
  for (const auto& [name, kind] :
       {std::pair("first", Kind::first), std::pair("last", Kind::last), std::pair("max", Kind::max),
        std::pair("min", Kind::min), std::pair("mean", Kind::mean)})
    if (text == name) return {kind, {}, 0};
  StateName state;
  std::string_view rest = text;
  if (rest.starts_with("rho_")) {
    const std::size_t end = std::min(rest.find_first_of("+-"), rest.size());
    state.transition = rest.substr(0, end);
    rest.remove_prefix(end);
    std::vector<std::string_view> known;
    for (const TransitionKind& kind : transition_kinds())
      if (kind.packing_fraction) known.push_back(kind.name);
    if (std::find(known.begin(), known.end(), state.transition) == known.end())
      throw usage_error(fmt::format("'{}' is no transition", state.transition), place,
                        fmt::format("one of {}", fmt::join(known, ", ")));
    if (rest.empty()) return state;
    if (rest.front() == '+') rest.remove_prefix(1);
  }
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), state.offset);
  if (error != std::errc{} || end != rest.data() + rest.size() || !std::isfinite(state.offset))
    throw usage_error(fmt::format("'{}' is no packing fraction", text), place,
                      "a number, first, last, max, min, mean, rho_c or rho_j+0.02");
  return state;
}

std::vector<Target> read_targets(std::string_view text, const std::string& file) {
  const toml::table document = parse_toml(text, file);
  std::vector<Target> targets;
  for (const auto& [key, node] : document) {
    const std::string name(key.str());
    if (name != "target") throw_unknown_key(name, {"target"}, place_of(file, key.source().begin));
    for (const toml::node& item : tables_of(node, "target", file))
      targets.push_back(read_target(*item.as_table(), file));
  }
  return targets;
}

}  // namespace jam
