#include "jamscape/study/results.hpp"

#include <fmt/format.h>

#include "jamscape/base/error.hpp"
#include "jamscape/study/builtin.hpp"
#include "jamscape/study/collected.hpp"
#include "jamscape/study/identity.hpp"
#include "jamscape/study/version.hpp"

namespace jam {
namespace {

namespace fs = std::filesystem;

std::string other_folder(const std::string& why) { return fmt::format("{}, or choose another folder with --out", why); }

/// What a runner makes before study.toml; shards may start at the same moment.
bool is_first_file(const std::string& name) { return name.starts_with("lock") || name == "study.toml.part"; }

FileLock take(const fs::path& file, LockMode mode, const std::string& what) {
  if (auto lock = FileLock::try_lock(file, mode)) return std::move(*lock);
  std::string holder = read_text(file);
  while (!holder.empty() && holder.back() == '\n') holder.pop_back();
  throw usage_error(fmt::format("{} is being worked on{}", what, holder.empty() ? "" : " by process " + holder),
                    file.parent_path().string(), "wait for it, or give each its share with --shard i/n");
}

}  // namespace

Study study_of_results(const fs::path& results) {
  std::error_code ignored;
  if (!fs::exists(results / "study.toml", ignored)) {
    const std::string file = fs::absolute(results).lexically_normal().filename().string() + ".toml";
    if (const std::string_view text = builtin_file(file); !text.empty() && is_collected(results))
      return read_study_text(text, "(built-in) " + file);
    throw usage_error("this is no folder of results: it holds no study.toml", results.string(),
                      "name the folder that `jamscape run` wrote");
  }
  return read_study(results / "study.toml");
}

void check_results(const fs::path& results, const Study& study) {
  std::error_code error;
  if (!fs::exists(results, error)) return;
  if (!fs::is_directory(results, error))
    throw usage_error("this is a file, not a folder", results.string(), "--out DIR");
  if (!fs::exists(results / "study.toml", error)) {
    for (const auto& entry : fs::directory_iterator(results, error))
      if (!is_first_file(entry.path().filename().string()))
        throw usage_error("the folder is not empty and holds no results of a study", results.string(),
                          "choose a new or empty folder with --out");
    return;
  }
  const Study old = study_of_results(results);
  if (old.info.name != study.info.name)
    throw usage_error(
        fmt::format("the folder holds results of the study '{}', not of '{}'", old.info.name, study.info.name),
        results.string(), "choose another folder with --out");
  if (old.info.seed != study.info.seed)
    throw usage_error(fmt::format("the folder holds results of seed {}, not of {}", old.info.seed, study.info.seed),
                      results.string(), other_folder(fmt::format("--set study.seed={}", old.info.seed)));
  for (const System& system : study.systems)
    for (const System& before : old.systems) {
      if (before.name != system.name || physics_key(before.options) == physics_key(system.options)) continue;
      const std::vector<std::string> there = differing_options(before.options, system.options),
                                     here = differing_options(system.options, before.options);
      throw usage_error(
          fmt::format("the folder holds results of another system '{}': {} there, {} here", system.name,
                      there.empty() ? "other stages" : there.front(), here.empty() ? "other stages" : here.front()),
          results.string(), other_folder("give the system another name"));
    }
}

void write_study(const fs::path& results, const Study& study) {
  make_folder(results);
  const FileLock lock = FileLock::lock(results / "lock.study");
  write_text(results / "study.toml",
             print_study(study) + fmt::format("\n[program]\nversion = {}\ncommit = {}\n", print_text(program_version()),
                                              print_text(program_commit())));
}

void write_results_study(const fs::path& results, const Study& study) {
  write_study(results, study);
  make_folder(results / "tasks");
}

RunnerLock::RunnerLock(const fs::path& results, const Shard& shard)
    : folder_(take(results / "lock", shard.count == 1 ? LockMode::exclusive : LockMode::shared, "the folder")) {
  if (shard.count > 1)
    shard_.emplace(take(results / fmt::format("lock.{}-of-{}", shard.index, shard.count), LockMode::exclusive,
                        fmt::format("shard {}/{}", shard.index, shard.count)));
}

}  // namespace jam
