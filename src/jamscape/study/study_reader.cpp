#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "jamscape/base/error.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/base/nearest.hpp"
#include "jamscape/study/study.hpp"
#include "jamscape/study/toml_leaves.hpp"

namespace jam {
namespace {

/// Assigns and says where, so that a later complaint about the option can point at it.
void set_option(const std::vector<Option>& options, const Leaf& leaf, std::map<std::string, std::string>& places) {
  assign(find_option(options, leaf), leaf.value);
  places[leaf.key] = leaf.place;
}

void check_name(const std::string& name, std::string_view allowed, const std::string& what, const std::string& place) {
  const auto good = [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           allowed.find(c) != std::string_view::npos;
  };
  if (!name.empty() && name.front() != '.' && std::all_of(name.begin(), name.end(), good)) return;
  throw usage_error(fmt::format("'{}' cannot be the name of a {}", name, what), place,
                    fmt::format("use letters, digits and {}", allowed));
}

std::vector<StageOptions> read_stages(const toml::node& node, const std::string& key, const std::string& file,
                                      std::map<std::string, std::string>& places) {
  std::vector<StageOptions> stages;
  std::set<std::string> names;
  for (const toml::node& item : tables_of(node, key, file)) {
    StageOptions stage;
    std::vector<Option> options = options_of(stage, "stage.");
    std::map<std::string, std::string> here;
    for (const Leaf& leaf : leaves_of(*item.as_table(), "stage.", file)) set_option(options, leaf, here);
    SystemOptions probe;
    probe.stages.assign(stages.size() + 1, stage);
    const std::string name = stage_name(probe, stages.size());
    const std::string place = place_of(file, item.source().begin);
    check_name(name, "_-", "stage", place);
    if (!names.insert(name).second)
      throw usage_error(fmt::format("two stages are named '{}'", name), place, "give one of them another name");
    stage.name = name;
    for (const auto& [path, at] : here) places["stage." + name + path.substr(5)] = at;
    stages.push_back(std::move(stage));
  }
  return stages;
}

std::string label(const Option& option) {
  std::string text = print_value(option);
  if (text.size() > 2 && text.ends_with(".0")) text.resize(text.size() - 2);
  std::erase_if(text, [](char c) { return c == '"' || c == '[' || c == ']' || c == ',' || c == ' '; });
  return text;
}

std::string last_part(const std::string& key) { return key.substr(key.rfind('.') + 1); }

/// Every system times every combination of the lists in [sweep].
std::vector<System> sweep(std::vector<System> systems, const std::vector<Leaf>& axes, bool named) {
  std::map<std::string, int> uses;
  for (const Leaf& axis : axes) ++uses[last_part(axis.key)];
  for (const Leaf& axis : axes) {
    const auto* values = std::get_if<std::vector<Written>>(&axis.value.value);
    if (!values || values->empty())
      throw usage_error(fmt::format("'sweep.{}' must be a list of values", axis.key), axis.place,
                        fmt::format("{} = [0.1, 0.2]", axis.key));
    std::vector<System> product;
    for (const System& system : systems)
      for (const Written& value : *values) {
        System next = system;
        const std::vector<Option> options = system_options(next.options);
        Leaf leaf{axis.key, value, axis.at, value.place};
        set_option(options, leaf, next.places);
        const std::string name = uses[last_part(axis.key)] > 1 ? axis.key : last_part(axis.key);
        const std::string part = name + "=" + label(find_option(options, leaf));
        next.name = named || &axis != &axes.front() ? system.name + "_" + part : part;
        product.push_back(std::move(next));
      }
    systems = std::move(product);
  }
  return systems;
}

Written parse_value(const Setting& setting, const std::string& place) {
  try {
    const toml::table parsed = toml::parse("value = " + setting.value);
    if (parsed.size() == 1) {
      Written value = written(*parsed.get("value"), "");
      value.place = place;
      return value;
    }
  } catch (const toml::parse_error&) {
  }
  return {setting.value, place};
}

class StudyReader {
 public:
  StudyReader(std::string file, const std::vector<Setting>& settings) : file_(std::move(file)) {
    study_.file = file_;
    for (const Setting& s : settings) {
      const std::string place = fmt::format("--set {}={}", s.key, s.value);
      settings_.push_back({s.key, parse_value(s, place), {}, place});
    }
  }

  Study read(const toml::table& document) {
    read_shared(document);
    read_systems(document);
    check();
    return std::move(study_);
  }

 private:
  std::vector<Option> shared_options() {
    std::vector<Option> options = options_of(study_.info, "study.");
    const auto append = [&](std::vector<Option> more) {
      for (Option& o : more) options.push_back(std::move(o));
    };
    append(system_options(study_.base));
    append(options_of(study_.measures, "measure."));
    append(options_of(study_.measure, "measure."));
    append(options_of(study_.report, "report."));
    return options;
  }

  void read_shared(const toml::table& document) {
    if (const toml::node* stages = document.get("stage"))
      study_.base.stages = read_stages(*stages, "stage", file_, places_);
    const std::vector<Option> options = shared_options();
    std::vector<std::string> sections = {"stage", "system", "sweep", "study", "measure", "report"};
    for (const Option& o : options_of(study_.base)) {
      const std::string section = o.key.substr(0, o.key.find('.'));
      if (std::find(sections.begin(), sections.end(), section) == sections.end()) sections.push_back(section);
    }
    for (const auto& [key, node] : document) {
      const std::string name(key.str());
      if (name == "stage" || name == "system" || name == "sweep" || name == "program") continue;
      if (std::find(sections.begin(), sections.end(), name) == sections.end())
        throw_unknown_key(name, sections, place_of(file_, key.source().begin));
      const toml::table* table = node.as_table();
      if (!table)
        throw usage_error(fmt::format("'{}' must be a table", name), place_of(file_, key.source().begin),
                          fmt::format("write [{}] on a line of its own", name));
      for (const Leaf& leaf : leaves_of(*table, name + ".", file_)) set_option(options, leaf, places_);
    }
    for (const Leaf& setting : settings_)
      if (!setting.key.starts_with("system.")) set_option(options, setting, places_);
  }

  void read_systems(const toml::table& document) {
    std::set<std::string> overridden;
    const bool named = document.contains("system");
    if (named) {
      for (const toml::node& node : tables_of(*document.get("system"), "system", file_))
        study_.systems.push_back(read_system(*node.as_table(), overridden));
    } else {
      study_.systems.push_back({study_.info.name, study_.base, places_});
    }
    if (const toml::node* node = document.get("sweep")) {
      if (!node->is_table()) throw usage_error("'sweep' must be a table", place_of(file_, node->source().begin));
      const std::vector<Leaf> axes = leaves_of(*node->as_table(), "", file_);
      for (const Leaf& axis : axes) overridden.insert(axis.key);
      study_.systems = sweep(std::move(study_.systems), axes, named);
    }
    for (const Leaf& setting : settings_) {
      if (overridden.contains(setting.key))
        throw usage_error(
            fmt::format("'{}' would have no effect: the systems of this study set it themselves", setting.key),
            setting.place, fmt::format("--set system.NAME.{}=...", setting.key));
      if (setting.key.starts_with("system.")) set_in_system(setting);
    }
  }

  System read_system(const toml::table& table, std::set<std::string>& overridden) {
    System system{{}, study_.base, places_};
    const std::string place = place_of(file_, table.source().begin);
    const toml::node* stages = table.get("stage");
    const bool own_stages = stages && stages->is_array();
    if (own_stages) system.options.stages = read_stages(*stages, "system.stage", file_, system.places);
    std::vector<Option> options = system_options(system.options);
    options.push_back({"name", {.text = "name of the system"}, &system.name});
    for (const Leaf& leaf : leaves_of(table, "", file_, own_stages ? "stage" : "")) {
      set_option(options, leaf, system.places);
      overridden.insert(leaf.key);
    }
    if (system.name.empty()) throw usage_error("a system has no name", place, "name = \"...\" below [[system]]");
    return system;
  }

  void set_in_system(const Leaf& setting) {
    const std::string rest = setting.key.substr(7);
    std::vector<std::string> names;
    for (System& system : study_.systems) {
      names.push_back(system.name);
      if (!rest.starts_with(system.name + ".")) continue;
      const Leaf leaf{rest.substr(system.name.size() + 1), setting.value, {}, setting.place};
      set_option(system_options(system.options), leaf, system.places);
      return;
    }
    throw usage_error(fmt::format("'{}' names no system of this study", setting.key), setting.place,
                      fmt::format("its systems are: {}", fmt::join(names, ", ")));
  }

  void check() {
    if (study_.info.name.empty()) throw usage_error("the study has no name", file_, "name = \"...\" below [study]");
    check_name(study_.info.name, "_.+-", "study", places_.contains("study.name") ? places_["study.name"] : file_);
    std::set<std::string> names;
    for (const System& system : study_.systems) {
      const std::string place = system.places.contains("name") ? system.places.at("name") : file_;
      check_name(system.name, "_.=+-", "system", place);
      if (!names.insert(system.name).second)
        throw usage_error(fmt::format("two systems are named '{}'", system.name), place,
                          "give one of them another name");
      if (system.options.stages.empty())
        throw usage_error(fmt::format("the system '{}' has no stages, so nothing would happen", system.name), file_,
                          "add a [[stage]]; `jamscape studies quickstart` shows one");
    }
  }

  std::string file_;
  std::vector<Leaf> settings_;
  Study study_;
  std::map<std::string, std::string> places_;
};

}  // namespace

Setting read_setting(std::string_view text) {
  const std::size_t equal = text.find('=');
  if (equal == 0 || equal == std::string_view::npos || equal + 1 == text.size())
    throw usage_error(fmt::format("'{}' is not of the form key=value", text), "--set", "--set contact.friction=0.3");
  return {std::string(text.substr(0, equal)), std::string(text.substr(equal + 1))};
}

Study read_study_text(std::string_view text, const std::string& file_name, const std::vector<Setting>& settings) {
  const toml::table document = parse_toml(text, file_name);
  return StudyReader(file_name, settings).read(document);
}

Study read_study(const std::filesystem::path& file, const std::vector<Setting>& settings) {
  std::string text;
  try {
    text = read_text(file);
  } catch (const Error& error) {
    throw usage_error(error.problem(), error.place(), "`jamscape studies` lists the built-in studies");
  }
  return read_study_text(text, file.string(), settings);
}

}  // namespace jam
