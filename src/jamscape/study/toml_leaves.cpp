#include "jamscape/study/toml_leaves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

/// Empty tables say nothing.
void flatten(const toml::table& table, const std::string& prefix, const std::string& file, std::string_view skip,
             std::vector<Leaf>& leaves) {
  for (const auto& [key, node] : table) {
    if (!skip.empty() && key.str() == skip) continue;
    const std::string path = prefix + std::string(key.str());
    const toml::source_position at = key.source().begin;
    if (const toml::table* inner = node.as_table(); inner && !inner->empty())
      flatten(*inner, path + ".", file, {}, leaves);
    else if (!inner)
      leaves.push_back({path, written(node, file), at, place_of(file, at)});
  }
  std::stable_sort(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) {
    return std::pair(a.at.line, a.at.column) < std::pair(b.at.line, b.at.column);
  });
}

/// What the letters of the trade are called here.
constexpr std::pair<std::string_view, std::string_view> symbols[] = {{"mu", "friction"},
                                                                     {"mu_s", "friction"},
                                                                     {"friction_coefficient", "friction"},
                                                                     {"e", "restitution"},
                                                                     {"cor", "restitution"},
                                                                     {"k", "stiffness"},
                                                                     {"k_n", "stiffness"},
                                                                     {"kn", "stiffness"},
                                                                     {"k_t", "tangential_stiffness"},
                                                                     {"kt", "tangential_stiffness"},
                                                                     {"dt", "step"},
                                                                     {"timestep", "step"},
                                                                     {"g", "gravity"},
                                                                     {"n", "count"},
                                                                     {"N", "count"},
                                                                     {"phi", "packing_fraction"},
                                                                     {"rho", "packing_fraction"},
                                                                     {"r_p", "width"},
                                                                     {"rp", "width"},
                                                                     {"polydispersity", "width"},
                                                                     {"v", "speed"},
                                                                     {"vc", "speed"},
                                                                     {"dim", "dimension"},
                                                                     {"d", "dimension"},
                                                                     {"seeds", "seed"},
                                                                     {"runs", "realisations"},
                                                                     {"realizations", "realisations"}};

/// The known key that is meant by a symbol, or "". The group may be wrong too.
std::string by_symbol(const std::string& key, const std::vector<std::string>& known) {
  const std::size_t dot = key.rfind('.');
  const std::string group = dot == std::string::npos ? "" : key.substr(0, dot + 1);
  const std::string_view last = std::string_view(key).substr(group.size());
  for (const auto& [symbol, name] : symbols) {
    if (symbol != last) continue;
    const std::string here = group + std::string(name), ending = fmt::format(".{}", name);
    if (std::find(known.begin(), known.end(), here) != known.end()) return here;
    for (const std::string& k : known)
      if (k.ends_with(ending)) return k;
  }
  return {};
}

std::vector<std::string> keys_of(const std::vector<Option>& options) {
  std::vector<std::string> keys;
  for (const Option& o : options) keys.push_back(o.key);
  return keys;
}

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw usage_error(std::string(error.description()), place_of(file, error.source().begin),
                      "the format is TOML: https://toml.io");
  }
}

std::string place_of(const std::string& file, toml::source_position at) {
  return fmt::format("{}:{}:{}", file, at.line, at.column);
}

Written written(const toml::node& node, const std::string& file) {
  const std::string place = place_of(file, node.source().begin);
  if (const auto* b = node.as_boolean()) return {b->get(), place};
  if (const auto* n = node.as_integer()) return {n->get(), place};
  if (const auto* x = node.as_floating_point()) return {x->get(), place};
  if (const auto* s = node.as_string()) return {s->get(), place};
  if (const auto* a = node.as_array()) {
    std::vector<Written> items;
    for (const toml::node& item : *a) items.push_back(written(item, file));
    return {std::move(items), place};
  }
  throw usage_error("a date, a time or a table stands where a value is expected", place);
}

std::vector<Leaf> leaves_of(const toml::table& table, const std::string& prefix, const std::string& file,
                            std::string_view skip) {
  std::vector<Leaf> leaves;
  flatten(table, prefix, file, skip, leaves);
  return leaves;
}

const Option& find_option(const std::vector<Option>& options, const Leaf& leaf) {
  for (const Option& o : options)
    if (o.key == leaf.key) return o;
  const std::vector<std::string> known = keys_of(options);
  if (const std::string meant = by_symbol(leaf.key, known); !meant.empty())
    throw usage_error(fmt::format("unknown key '{}'", leaf.key), leaf.place, fmt::format("did you mean '{}'?", meant));
  throw_unknown_key(leaf.key, known, leaf.place);
}

const toml::array& tables_of(const toml::node& node, const std::string& name, const std::string& file) {
  const toml::array* array = node.as_array();
  const bool tables = array && !array->empty() && array->is_homogeneous(toml::node_type::table);
  if (!tables)
    throw usage_error(fmt::format("'{}' must be a list of tables", name), place_of(file, node.source().begin),
                      fmt::format("write [[{}]] above each", name));
  return *array;
}

}  // namespace jam
