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
  throw_unknown_key(leaf.key, keys_of(options), leaf.place);
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
