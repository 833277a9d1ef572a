#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>

#include "commands.hpp"
#include "complain.hpp"
#include "jamscape/base/file_lacks.hpp"
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

/// The output may be a full disk or a pipe without a reader: what did not arrive is said, and is no success.
ExitCode check_output(ExitCode code) {
  errno = 0;
  if (code != ExitCode::done || (std::fflush(stdout) == 0 && std::ferror(stdout) == 0)) return code;
  throw data_error(fmt::format("cannot write: {}", errno != 0 ? std::strerror(errno) : "the output was cut short"),
                   "standard output");
}

void print_notes() {
  for (const std::string& lack : jam::take_lacks()) app::complain("note: {}\n", lack);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const ExitCode code = check_output(run_program(argc, argv));
    print_notes();
    return static_cast<int>(code);
  } catch (const jam::Error& error) {
    print_notes();
    jam::app::complain("error: {}\n", error.what());
    return static_cast<int>(error.code());
  } catch (const std::bad_alloc&) {
    jam::app::complain(
        "error: there is not enough memory for this\n  try: a machine with more, fewer jobs at a time, or a smaller "
        "packing or network\n");
    return static_cast<int>(jam::ExitCode::data);
  } catch (const std::system_error& error) {  // of fmt::print
    jam::app::complain("error: {}\n", error.what());
    return static_cast<int>(jam::ExitCode::data);
  } catch (const std::exception& error) {
    jam::app::complain("error: {}\n  this is a bug in jamscape; please report it with the command you ran\n",
                       error.what());
    return static_cast<int>(jam::ExitCode::bug);
  }
}
