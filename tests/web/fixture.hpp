// A folder of results that looks like one of `jamscape run`, made of smooth functions and random numbers in a second:
// three systems of a few hundred grains, all tables and stored frames. Nothing in it was simulated.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace jam {

struct FixtureParts {
  bool ensemble = true;     ///< ensemble/*.csv
  bool tasks = true;        ///< stored frames and diagrams
  bool transitions = true;  ///< ensemble/transitions.csv
  std::string title = "Synthetic results";
};

void write_fixture(const std::filesystem::path& folder, const FixtureParts& parts = {});

/// Three systems, two of discs and one of spheres, with relaxations and level sets.
void write_network_fixture(const std::filesystem::path& folder);

/// Six systems of clusters in containers, crosses in two dimensions and stars in a cylinder.
void write_cluster_fixture(const std::filesystem::path& folder, std::int64_t grains = 60);

}  // namespace jam
