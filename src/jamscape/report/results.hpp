// A folder of results, as the report sees it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "jamscape/base/table.hpp"
#include "jamscape/report/marks.hpp"
#include "jamscape/report/relaxation.hpp"
#include "jamscape/study/damage.hpp"
#include "jamscape/study/study.hpp"

namespace jam {

struct Results {
  std::filesystem::path folder;
  ResultPlaces places;  ///< of the simulations and their rows; the folder, where nothing else is said
  Study study;
  std::string version, commit;  ///< of the program that wrote the results; empty where unknown
  Relaxations relaxations;      ///< per system; all empty where the study relaxes nothing
  FrameSets states;             ///< per system, the frames curves are made of; empty where all are
  Marks marks;                  ///< per system, frames whose energy ledger is off
  std::vector<LeftOut> left_out = {};

  /// A table below the folder, e.g. "ensemble/frames.csv"; nothing when there is no such file.
  std::optional<Table> table(std::string_view name) const;
  /// Index of a system by name, or -1.
  int system(std::string_view name) const;
};

/// Throws a data error when the folder holds no readable study.toml.
Results open_results(const std::filesystem::path& folder);

/// A column as text, whatever it holds; empty strings when there is no such column.
std::vector<std::string> text_column(const Table& table, std::string_view name);

}  // namespace jam
