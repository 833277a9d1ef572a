// Tasks: one per system and realisation, in that order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "jamscape/protocol/simulate.hpp"
#include "jamscape/study/study.hpp"

namespace jam {

struct Task {
  std::size_t system = 0;  ///< index in Study::systems
  std::uint64_t realisation = 0;
  TaskKey key;
  std::string hash;
  Plan plan;

  /// Grains times steps: what it costs.
  double cost() const { return static_cast<double>(plan.steps) * static_cast<double>(plan.bodies); }
};

/// All tasks, planned; systems with equal physics share tasks of one hash. Throws a usage error with the place in the
/// study file for a system that cannot be.
std::vector<Task> plan_tasks(const Study& study);

/// The tasks of results that are there: with the plans their folders hold (plan_file.hpp). Only what was never run, or
/// by an earlier version, is planned.
std::vector<Task> stored_tasks(const Study& study, const std::filesystem::path& results);

/// The tasks of the systems of these names. Throws a usage error for a name that no system has.
std::vector<Task> tasks_of(const Study& study, const std::vector<Task>& tasks, const std::vector<std::string>& systems);

/// Which part of the tasks a runner does: tasks index, index + count, ... (index from 1 as on the command line).
struct Shard {
  int index = 1, count = 1;
};

/// Reads "i/n"; throws a usage error.
Shard read_shard(const std::string& text);

/// The indices of the tasks to be done by a shard: each hash once, the longest first; among those about equally long
/// the first realisation of every system before the second of any, so that ensembles grow evenly.
std::vector<std::size_t> order_tasks(const std::vector<Task>& tasks, const Shard& shard);

}  // namespace jam
