#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "jamscape/base/error.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/base/nearest.hpp"
#include "jamscape/study/names.hpp"
#include "jamscape/study/study.hpp"
#include "jamscape/study/system_text.hpp"

namespace jam {
namespace {

std::string label(const Option& option) {
  std::string text = print_value(option);
  if (text.size() > 2 && text.ends_with(".0")) text.resize(text.size() - 2);
  std::erase_if(text, [](char c) { return c == '"' || c == '[' || c == ']' || c == ',' || c == ' '; });
  return text;
}

std::string last_part(const std::string& key) { return key.substr(key.rfind('.') + 1); }

/// Every system times every combination of the lists in [sweep].
std::vector<SystemText> sweep(std::vector<SystemText> systems, const std::vector<Leaf>& axes, bool named) {
  std::map<std::string, int> uses;
  for (const Leaf& axis : axes) ++uses[last_part(axis.key)];
  for (const Leaf& axis : axes) {
    const auto* values = std::get_if<std::vector<Written>>(&axis.value.value);
    if (!values || values->empty())
      throw usage_error(fmt::format("'sweep.{}' must be a list of values", axis.key), axis.place,
                        fmt::format("{} = [0.1, 0.2]", axis.key));
    std::vector<SystemText> product;
    for (const SystemText& system : systems) {
      std::set<std::string> given;
      for (const Written& value : *values) {
        SystemText next = system;
        const Leaf leaf{axis.key, value, axis.at, value.place};
        next.leaves.push_back(leaf);
        System made = make_system(next);
        std::vector<Option> options = system_options(made.options);
        for (Option& o : options_of(made.units, "units.")) options.push_back(std::move(o));
        const std::string name = uses[last_part(axis.key)] > 1 ? axis.key : last_part(axis.key);
        const std::string value_text = label(find_option(options, leaf));
        if (!given.insert(value_text).second)
          throw usage_error(fmt::format("'sweep.{}' has the value {} twice", axis.key, value_text), value.place,
                            "each value once");
        const std::string part = name + "=" + value_text;
        next.name = named || &axis != &axes.front() ? system.name + "_" + part : part;
        product.push_back(std::move(next));
      }
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
  /// Options of the study that are of no system.
  std::vector<Option> own_options() {
    std::vector<Option> options = options_of(study_.info, "study.");
    const auto append = [&](std::vector<Option> more) {
      for (Option& o : more) options.push_back(std::move(o));
    };
    append(options_of(study_.measures, "measure."));
    append(options_of(study_.measure, "measure."));
    append(options_of(study_.report, "report."));
    return options;
  }

  static bool is_own(const Leaf& leaf) {
    return leaf.key.starts_with("study.") || leaf.key.starts_with("measure.") || leaf.key.starts_with("report.");
  }

  void read_shared(const toml::table& document) {
    if (const toml::node* stages = document.get("stage")) read_stages(*stages, "stage", file_, shared_);
    std::vector<std::string> sections = {"stage", "system", "sweep", "study", "measure", "report", "units"};
    for (const Option& o : options_of(study_.base)) {
      const std::string section = o.key.substr(0, o.key.find('.'));
      if (std::find(sections.begin(), sections.end(), section) == sections.end()) sections.push_back(section);
    }
    std::vector<Leaf> own;
    for (const auto& [key, node] : document) {
      const std::string name(key.str());
      if (name == "stage" || name == "system" || name == "sweep" || name == "program") continue;
      if (std::find(sections.begin(), sections.end(), name) == sections.end())
        throw_unknown_key(name, sections, place_of(file_, key.source().begin));
      const toml::table* table = node.as_table();
      if (!table)
        throw usage_error(fmt::format("'{}' must be a table", name), place_of(file_, key.source().begin),
                          fmt::format("write [{}] on a line of its own", name));
      for (Leaf& leaf : leaves_of(*table, name + ".", file_)) (is_own(leaf) ? own : shared_.leaves).push_back(leaf);
    }
    for (const Leaf& setting : settings_)
      if (!setting.key.starts_with("system.")) (is_own(setting) ? own : shared_.leaves).push_back(setting);

    const System base = make_system(shared_);
    study_.base = base.options, study_.units = base.units;
    const std::vector<Option> options = own_options();
    for (const Leaf& leaf : own) {
      assign(find_option(options, leaf), leaf.value, base.scales);
      places_[leaf.key] = leaf.place;
    }
    // A measure that is asked for by name is taken at every frame, unless the study says otherwise.
    if (!study_.measures.list.empty() && !places_.contains("measure.rows_every")) study_.measure.rows_every = 0;
  }

  void read_systems(const toml::table& document) {
    std::set<std::string> overridden;
    std::vector<SystemText> systems;
    const bool named = document.contains("system");
    if (named) {
      for (const toml::node& node : tables_of(*document.get("system"), "system", file_))
        systems.push_back(read_system(*node.as_table(), overridden));
    } else {
      systems.push_back(shared_);
      systems.back().name = study_.info.name;
    }
    if (const toml::node* node = document.get("sweep")) {
      if (!node->is_table()) throw usage_error("'sweep' must be a table", place_of(file_, node->source().begin));
      const std::vector<Leaf> axes = leaves_of(*node->as_table(), "", file_);
      for (const Leaf& axis : axes) overridden.insert(axis.key);
      systems = sweep(std::move(systems), axes, named);
    }
    for (const Leaf& setting : settings_) {
      if (overridden.contains(setting.key))
        throw usage_error(
            fmt::format("'{}' would have no effect: the systems of this study set it themselves", setting.key),
            setting.place, fmt::format("--set system.NAME.{}=...", setting.key));
      if (setting.key.starts_with("system.")) set_in_system(setting, systems);
    }
    for (const SystemText& text : systems) study_.systems.push_back(make_system(text));
  }

  SystemText read_system(const toml::table& table, std::set<std::string>& overridden) {
    SystemText system = shared_;
    const std::string place = place_of(file_, table.source().begin);
    const toml::node* stages = table.get("stage");
    const bool own_stages = stages && stages->is_array();
    if (own_stages) read_stages(*stages, "system.stage", file_, system);
    const Option name{"name", {.text = "name of the system"}, &system.name};
    for (Leaf& leaf : leaves_of(table, "", file_, own_stages ? "stage" : "")) {
      overridden.insert(leaf.key);
      if (leaf.key == "name")
        assign(name, leaf.value), name_places_[system.name] = leaf.place;
      else
        system.leaves.push_back(std::move(leaf));
    }
    if (system.name.empty()) throw usage_error("a system has no name", place, "name = \"...\" below [[system]]");
    return system;
  }

  static void set_in_system(const Leaf& setting, std::vector<SystemText>& systems) {
    const std::string rest = setting.key.substr(7);
    std::vector<std::string> names;
    for (SystemText& system : systems) {
      names.push_back(system.name);
      if (!rest.starts_with(system.name + ".")) continue;
      system.leaves.push_back({rest.substr(system.name.size() + 1), setting.value, {}, setting.place});
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
      const std::string place = name_places_.contains(system.name) ? name_places_.at(system.name) : file_;
      check_name(system.name, "_.=+-", "system", place);
      if (!names.insert(system.name).second)
        throw usage_error(fmt::format("two systems are named '{}'", system.name), place,
                          "give one of them another name");
      if (system.options.stages.empty())
        throw usage_error(fmt::format("the system '{}' has no stages, so nothing would happen", system.name), file_,
                          "add a [[stage]]; `jamscape studies quickstart` shows one");
    }
    check_measures();
  }

  void check_measures() {
    try {
      jam::check(study_.measure);
    } catch (const Error& error) {
      const auto place = places_.find(error.place());
      throw usage_error(error.problem(), place != places_.end() ? place->second : file_ + ": " + error.place(),
                        error.suggestion());
    }
  }

  std::string file_;
  std::vector<Leaf> settings_;
  Study study_;
  SystemText shared_;                               ///< what all systems begin with
  std::map<std::string, std::string> places_;       ///< of the study's own keys
  std::map<std::string, std::string> name_places_;  ///< where systems are named
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
