// The folder of a study's results:
//
//   DIR/study.toml        the resolved study and the program that made it
//   DIR/tasks/<hash>/     task_folder.hpp
//   DIR/tables/*.csv      tables.hpp
//   DIR/ensemble/*.csv    ensemble.hpp, transitions.hpp
//   DIR/lock*             held while a runner works (alone, or shared by the shards of one study) and while study.toml
//                         and the tables are written
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "jamscape/base/files.hpp"
#include "jamscape/study/study.hpp"
#include "jamscape/study/task.hpp"

namespace jam {

/// The study whose results a folder holds; throws a usage error when it is no folder of results. Collected tables
/// (collected.hpp) without a study.toml belong to the built-in study that the folder is named after.
Study study_of_results(const std::filesystem::path& results);

/// Throws a usage error unless the folder is absent, empty, or holds results of this study: the same name and seed, and
/// the same physics in systems of the same name. Realisations, systems, measures and frames may differ. Touches
/// nothing.
void check_results(const std::filesystem::path& results, const Study& study);

/// Makes the folder and writes study.toml.
void write_study(const std::filesystem::path& results, const Study& study);
/// The same, with a place for tasks.
void write_results_study(const std::filesystem::path& results, const Study& study);

/// Keeps other runners out while it lives.
class RunnerLock {
 public:
  /// Throws a usage error with the other's process id when the folder, or this shard of it, is being worked on.
  RunnerLock(const std::filesystem::path& results, const Shard& shard);

 private:
  FileLock folder_;
  std::optional<FileLock> shard_;
};

}  // namespace jam
