#include "lammps_program.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace jam::lammps {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

bool installed() { return std::system("command -v lmp >/dev/null 2>&1") == 0; }

void run(const fs::path& folder, const std::string& script, const std::string& variables) {
  const std::string command = "cd '" + folder.string() + "' && OMP_NUM_THREADS=1 lmp -in " + script + ".in -log " +
                              script + ".log -screen none " + variables + " </dev/null >" + script + ".out 2>&1";
  if (std::system(command.c_str()) == 0) return;
  const std::string said = text_of(folder / (script + ".log")) + text_of(folder / (script + ".out"));
  throw std::runtime_error(command + "\nended with:\n" + said.substr(said.size() > 1500 ? said.size() - 1500 : 0));
}

std::vector<std::vector<double>> rows_of(const fs::path& path) {
  std::ifstream in(path);
  std::string line;
  while (std::getline(in, line) && !line.starts_with("ITEM: ATOMS") && !line.starts_with("ITEM: ENTRIES")) {
  }
  std::vector<std::vector<double>> rows;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    rows.emplace_back(std::istream_iterator<double>(words), std::istream_iterator<double>());
  }
  if (rows.empty()) throw std::runtime_error("no rows in " + path.string());
  return rows;
}

}  // namespace jam::lammps
