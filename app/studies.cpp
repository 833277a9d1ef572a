#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "jamscape/base/nearest.hpp"
#include "jamscape/study/builtin.hpp"
#include "jamscape/study/study.hpp"

namespace jam::app {
namespace {

ExitCode list_studies() {
  for (const std::string_view name : builtin_studies()) {
    const std::string file = std::string(name) + ".toml";
    const Study study = read_study_text(builtin_file(file), file);
    fmt::print("{:28} {}\n", name, study.info.title);
  }
  fmt::print("\n`jamscape studies NAME` prints one, `jamscape run NAME` runs it.\n");
  return ExitCode::done;
}

ExitCode print_one(const std::string& name) {
  std::string_view text = builtin_file(name);
  if (text.empty()) text = builtin_file(name + ".toml");
  if (text.empty()) {
    std::vector<std::string> known;
    for (const std::string_view study : builtin_studies()) known.emplace_back(study);
    const std::string near = nearest(name, known);
    throw usage_error(fmt::format("there is no built-in study '{}'", name), "jamscape studies",
                      near.empty() ? "jamscape studies" : fmt::format("jamscape studies {}", near));
  }
  fmt::print("{}", text);
  return ExitCode::done;
}

}  // namespace

void add_studies(CLI::App& program, Action& action) {
  CLI::App* sub = program.add_subcommand("studies", "List the built-in studies, or print one");
  auto name = std::make_shared<std::string>();
  sub->add_option("name", *name, "the study to print");
  sub->callback([name, &action] { action = [name] { return name->empty() ? list_studies() : print_one(*name); }; });
}

}  // namespace jam::app
