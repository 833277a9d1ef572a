#include "jamscape/study/system_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "jamscape/base/error.hpp"
#include "jamscape/study/names.hpp"

namespace jam {
namespace {

/// Names of things and whole units come first: what numbers mean hangs on them.
bool comes_first(const Option& option) {
  return std::holds_alternative<EnumTarget>(option.target) || option.meta.si || option.key == "units.poisson";
}

}  // namespace

void read_stages(const toml::node& node, const std::string& key, const std::string& file, SystemText& text) {
  std::erase_if(text.leaves, [](const Leaf& leaf) { return leaf.key.starts_with("stage."); });
  text.stages.clear();
  std::set<std::string> names;
  for (const toml::node& item : tables_of(node, key, file)) {
    std::vector<Leaf> leaves = leaves_of(*item.as_table(), "stage.", file);
    SystemOptions probe;
    probe.stages.resize(text.stages.size() + 1);
    std::vector<Option> options = options_of(probe.stages.back(), "stage.");
    for (const Leaf& leaf : leaves)
      if (const Option& o = find_option(options, leaf); leaf.key == "stage.name" || leaf.key == "stage.kind")
        assign(o, leaf.value);
    const std::string name = stage_name(probe, text.stages.size()), place = place_of(file, item.source().begin);
    check_name(name, "_-", "stage", place);
    if (!names.insert(name).second)
      throw usage_error(fmt::format("two stages are named '{}'", name), place, "give one of them another name");
    text.stages.push_back(name);
    for (Leaf& leaf : leaves) {
      leaf.key = "stage." + name + leaf.key.substr(5);
      text.leaves.push_back(std::move(leaf));
    }
  }
}

System make_system(const SystemText& text) {
  System system;
  system.name = text.name;
  for (const std::string& name : text.stages) {
    system.options.stages.emplace_back();
    system.options.stages.back().name = name;
  }
  std::vector<Option> options = system_options(system.options);
  for (Option& o : options_of(system.units, "units.")) options.push_back(std::move(o));
  std::vector<Leaf> rest;
  for (const Leaf& leaf : text.leaves) {
    const Option& o = find_option(options, leaf);
    system.places[leaf.key] = leaf.place;
    if (comes_first(o))
      assign(o, leaf.value);
    else
      rest.push_back(leaf);
  }
  system.scales = scales_of(system.units, system.options.contact.law, system.places);
  options = system_options(system.options);
  for (const Leaf& leaf : rest) assign(find_option(options, leaf), leaf.value, system.scales);
  for (std::size_t k = 0; k < text.stages.size(); ++k) {
    std::string& name = system.options.stages[k].name;
    if (!name.empty() && name != text.stages[k])
      throw usage_error(
          fmt::format("the stage '{}' cannot be renamed to '{}': its keys go by its name", text.stages[k], name),
          system.places["stage." + text.stages[k] + ".name"], "change the name where the stage is written");
    name = text.stages[k];
  }
  set_material(system.units, system.scales, system.options.contact, system.places);
  return system;
}

}  // namespace jam
