// The subcommands. Each adds itself to the program and, when chosen, sets the exit code.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "jamscape/base/error.hpp"

namespace jam::app {

/// What a chosen subcommand does; its result is the exit code of the program.
using Action = std::function<ExitCode()>;

void add_run(CLI::App& program, Action& action);
void add_results_commands(CLI::App& program, Action& action);  ///< report, score, verify, view, export
void add_measure(CLI::App& program, Action& action);
void add_persistence(CLI::App& program, Action& action);
void add_status(CLI::App& program, Action& action);
void add_studies(CLI::App& program, Action& action);
void add_shapes(CLI::App& program, Action& action);
void add_explain(CLI::App& program, Action& action);

}  // namespace jam::app
