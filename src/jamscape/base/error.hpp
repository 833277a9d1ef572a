// Errors a person reads: problem, reason, place, and what to try.
#pragma once

#include <stdexcept>
#include <string>

namespace jam {

/// Exit codes of the program; every error names the one it ends in.
enum class ExitCode : int {
  done = 0,
  usage = 2,          ///< command line or study file
  data = 3,           ///< input data: unreadable, truncated, inconsistent
  not_converged = 4,  ///< only with --strict
  interrupted = 5,    ///< stopped by a signal, resumable
  some_failed = 6,    ///< some tasks failed
  bug = 70,
};

/// An error with all that is needed to mend its cause.
/// what() shows control bytes of its parts as \x1b, so that no file steers a terminal.
/// `problem` is one sentence; `place` is file:line:column (or empty); `suggestion` says what to try (or is empty).
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, std::string problem, std::string place = {}, std::string suggestion = {});

  ExitCode code() const noexcept { return code_; }
  const std::string& problem() const noexcept { return problem_; }
  const std::string& place() const noexcept { return place_; }
  const std::string& suggestion() const noexcept { return suggestion_; }

 private:
  ExitCode code_;
  std::string problem_, place_, suggestion_;
};

/// A mistake in a study file or on the command line (exit code 2).
Error usage_error(std::string problem, std::string place = {}, std::string suggestion = {});
/// Input data that cannot be used (exit code 3).
Error data_error(std::string problem, std::string place = {}, std::string suggestion = {});

}  // namespace jam
