// Running LAMMPS and reading what it leaves.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace jam::lammps {

/// Whether the program lmp can be run.
bool installed();

/// Runs `script`.in in this folder, as one process with one thread; `variables`: "-var name value ...". Throws
/// std::runtime_error with the log's end if LAMMPS fails.
void run(const std::filesystem::path& folder, const std::string& script, const std::string& variables);

/// The rows of a LAMMPS dump of one instant.
std::vector<std::vector<double>> rows_of(const std::filesystem::path& path);

}  // namespace jam::lammps
