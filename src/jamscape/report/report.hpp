// Stored results become one page: DIR/report.html, whole in one file, opened from the disk without a network.
#pragma once

#include <filesystem>

namespace jam {

/// Reads DIR/study.toml, DIR/tables, DIR/ensemble and the stored frames of one realisation per system, and writes
/// DIR/report.html aside and renames it. A result that is not there leaves out the part of the page that shows it.
/// Throws a data error when DIR holds no study, or a file that cannot be read.
void write_report(const std::filesystem::path& results_dir);

}  // namespace jam
