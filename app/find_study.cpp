#include "find_study.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "jamscape/base/error.hpp"
#include "jamscape/base/nearest.hpp"
#include "jamscape/study/builtin.hpp"

namespace jam::app {

Study find_study(const std::string& name, const std::vector<std::string>& settings) {
  std::vector<Setting> changes;
  for (const std::string& text : settings) changes.push_back(read_setting(text));
  std::error_code ignored;
  // A plain name of a built-in study means that study, even beside a file of that name such as the script `quickstart`.
  const std::string_view own = name.ends_with(".toml") ? std::string_view() : builtin_file(name + ".toml");
  if (!own.empty() && !std::filesystem::is_directory(name, ignored))
    return read_study_text(own, "(built-in) " + name + ".toml", changes);
  if (std::filesystem::exists(name, ignored) || name.find('/') != std::string::npos) return read_study(name, changes);
  const std::string file = name.ends_with(".toml") ? name : name + ".toml";
  if (const std::string_view text = builtin_file(file); !text.empty())
    return read_study_text(text, "(built-in) " + file, changes);
  std::vector<std::string> known;
  for (const std::string_view study : builtin_studies()) known.emplace_back(study);
  const std::string near = nearest(name, known);
  throw usage_error(
      "there is no such file, and no built-in study of that name", name,
      near.empty() ? "`jamscape studies` lists the built-in studies" : fmt::format("did you mean '{}'?", near));
}

}  // namespace jam::app
