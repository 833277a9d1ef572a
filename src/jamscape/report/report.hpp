// Stored results become one page: DIR/report.html, whole in one file, opened from the disk without a network.
#pragma once

#include <filesystem>
#include <vector>

#include "jamscape/study/damage.hpp"

namespace jam {

/// Reads DIR/study.toml, DIR/tables, DIR/ensemble and the stored frames of one realisation per system, and writes
/// DIR/report.html aside and renames it. A result that is not there leaves out the part of the page that shows it.
/// Throws a data error when DIR holds no study, or a file that cannot be read. Simulations may stand elsewhere
/// (`places`), and some of them be left out. Returns those that proved damaged when their pictures were drawn.
std::vector<LeftOut> write_report(const std::filesystem::path& results_dir, const ResultPlaces& places,
                                  const std::vector<LeftOut>& left_out);
std::vector<LeftOut> write_report(const std::filesystem::path& results_dir);

}  // namespace jam
