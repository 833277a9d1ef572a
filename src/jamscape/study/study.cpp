#include "jamscape/study/study.hpp"

#include <fmt/format.h>

#include <optional>

namespace jam {
namespace {

std::vector<std::string> stage_names(const SystemOptions& system) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < system.stages.size(); ++k) names.push_back(stage_name(system, k));
  return names;
}

/// "[section]" lines and below each its options.
std::string print_sections(const std::vector<Option>& options) {
  std::string text, section;
  for (const Option& o : options) {
    const std::size_t dot = o.key.rfind('.');
    if (o.key.substr(0, dot) != section) {
      section = o.key.substr(0, dot);
      text += fmt::format("\n[{}]\n", section);
    }
    text += fmt::format("{} = {}\n", o.key.substr(dot + 1), print_value(o));
  }
  return text;
}

std::string print_stages(SystemOptions system, std::string_view heading) {
  std::string text;
  for (StageOptions& stage : system.stages) {
    text += fmt::format("\n[[{}]]\n", heading);
    for (const Option& o : options_of(stage)) text += fmt::format("{} = {}\n", o.key, print_value(o));
  }
  return text;
}

std::optional<std::string> value_of(SystemOptions system, const std::string& key) {
  for (const Option& o : system_options(system))
    if (o.key == key) return print_value(o);
  return std::nullopt;
}

/// One line of `key = value` for each option that differs; the two structs are of one kind.
template <class S>
std::vector<std::string> differing(S s, S other, const std::string& prefix) {
  const std::vector<Option> here = options_of(s, prefix), there = options_of(other, prefix);
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < here.size(); ++k)
    if (const std::string value = print_value(here[k]); value != print_value(there[k]))
      lines.push_back(here[k].key + " = " + value);
  return lines;
}

/// Sections of a study with units; those left at 0 are not given.
std::string print_units(const UnitOptions& units) {
  std::string text;
  for (const std::string& line : differing(units, UnitOptions{}, "")) text += line + "\n";
  return text.empty() ? "" : "\n[units]\n" + text;
}

}  // namespace

std::vector<Option> system_options(SystemOptions& system) {
  std::vector<Option> options = options_of(system);
  if (hertzian(system.contact.law))
    for (Option& o : options)
      if (o.key == "contact.stiffness") o.meta.unit = "m/(d^0.5 tau_c^2)";
  for (std::size_t k = 0; k < system.stages.size(); ++k)
    for (Option& o : options_of(system.stages[k], "stage." + stage_name(system, k) + "."))
      options.push_back(std::move(o));
  return options;
}

std::vector<std::string> differing_options(const SystemOptions& system, const SystemOptions& other) {
  SystemOptions a = system;
  std::vector<std::string> lines;
  for (const Option& o : system_options(a)) {
    const std::string value = print_value(o);
    if (value_of(other, o.key) != value) lines.push_back(o.key + " = " + value);
  }
  return lines;
}

std::string print_study(const Study& study) {
  Study s = study;
  std::string text =
      print_sections(options_of(s.info, "study.")) + print_units(s.units) + print_sections(options_of(s.base));
  text += print_stages(s.base, "stage");
  for (const System& system : s.systems) {
    const bool own_stages = stage_names(system.options) != stage_names(s.base);
    text += fmt::format("\n[[system]]\nname = {}\n", print_text(system.name));
    if (system.scales.known()) text += "# " + describe_scales(system.scales) + "\n";
    for (const std::string& line : differing(system.units, s.units, "units.")) text += line + "\n";
    for (const std::string& line : differing_options(system.options, s.base))
      if (!own_stages || !line.starts_with("stage.")) text += line + "\n";
    if (own_stages) text += print_stages(system.options, "system.stage");
  }
  std::vector<Option> measure = options_of(s.measures, "measure.");
  for (Option& o : options_of(s.measure, "measure.")) measure.push_back(std::move(o));
  text += print_sections(measure) + print_sections(options_of(s.report, "report."));
  return text.substr(1);
}

std::vector<std::string> varied_options(const Study& study) {
  std::vector<std::string> keys;
  if (study.systems.empty()) return keys;
  SystemOptions first = study.systems.front().options;
  for (const Option& o : system_options(first)) {
    const bool list = std::holds_alternative<std::vector<double>*>(o.target);
    const bool of_output = o.key.starts_with("stage.") && (o.key.ends_with(".name") || o.key.ends_with(".frames") ||
                                                           o.key.ends_with(".frames_inside"));
    if (list || of_output) continue;
    const std::string value = print_value(o);
    bool everywhere = true, differs = false;
    for (const System& system : study.systems) {
      const std::optional<std::string> other = value_of(system.options, o.key);
      everywhere = everywhere && other.has_value();
      differs = differs || other != value;
    }
    if (everywhere && differs) keys.push_back(o.key);
  }
  return keys;
}

std::vector<KnownOption> known_options() {
  Study s;
  StageOptions stage;
  std::vector<KnownOption> known;
  const auto append = [&](const std::vector<Option>& options) {
    for (const Option& o : options)
      known.push_back({o.key, describe_type(o), describe_range(o.meta), print_value(o), o.meta});
  };
  append(options_of(s.info, "study."));
  append(options_of(s.units, "units."));
  append(options_of(s.base));
  append(options_of(stage, "stage."));
  append(options_of(s.measures, "measure."));
  append(options_of(s.measure, "measure."));
  append(options_of(s.report, "report."));
  return known;
}

}  // namespace jam
