#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "commands.hpp"
#include "jamscape/base/nearest.hpp"
#include "jamscape/study/version.hpp"

namespace {

using namespace jam;

/// CLI11 says "unexpected arguments" for a subcommand it does not know; people want the name of the nearest.
void check_subcommand(CLI::App& program, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* sub : program.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(sub->get_name());
  for (const std::string& name : names)
    if (name == argv[1]) return;
  const std::string near = nearest(argv[1], names);
  throw usage_error(fmt::format("unknown command '{}'", argv[1]), "jamscape",
                    near.empty() ? "jamscape --help" : fmt::format("jamscape {}", near));
}

ExitCode run_program(int argc, char** argv) {
  CLI::App program("Granular packings, their force networks and the topology of both", "jamscape");
  program.require_subcommand(1);
  program.set_version_flag("--version", fmt::format("jamscape {} ({})", program_version(), program_commit()));
  program.footer("`jamscape COMMAND --help` explains a command, `jamscape explain KEY` an option or a measure.");
  app::Action action;
  app::add_run(program, action);
  app::add_status(program, action);
  app::add_results_commands(program, action);
  app::add_measure(program, action);
  app::add_persistence(program, action);
  app::add_studies(program, action);
  app::add_shapes(program, action);
  app::add_explain(program, action);
  check_subcommand(program, argc, argv);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      program.exit(error);
      return ExitCode::done;
    }
    const std::string command = argc > 1 && argv[1][0] != '-' ? fmt::format("jamscape {}", argv[1]) : "jamscape";
    throw usage_error(error.what(), command, command + " --help");
  }
  return action();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return static_cast<int>(run_program(argc, argv));
  } catch (const jam::Error& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return static_cast<int>(error.code());
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n  this is a bug in jamscape; please report it with the command you ran\n",
               error.what());
    return static_cast<int>(jam::ExitCode::bug);
  }
}
