// Prints the generated pages of docs/reference, or says which of those stored are stale.
//
//   reference FOLDER            compares
//   reference --write FOLDER    writes
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "jamscape/observe/explain.hpp"
#include "jamscape/study/study.hpp"

namespace {

constexpr const char* origin = "<!-- Generated from the declarations in the code; do not edit. -->";

/// In a cell of a table, a bar would end it.
std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

std::string options_page() {
  std::string page = fmt::format(
      "{}\n\n# Options of a study file\n\n"
      "`jamscape explain KEY` prints the same. Numbers are in scaled units: the mean diameter d, the mean mass m "
      "and the collision time tau_c. Options of a stage stand in a `[[stage]]` table, or as `stage.NAME.key` in a "
      "`[[system]]`. Sources: S1 and S2 as in [references.bib](../references.bib), theory is "
      "[theory.md](../theory.md).\n",
      origin);
  std::string group = "?";
  for (const jam::KnownOption& o : jam::known_options()) {
    const std::size_t dot = o.key.find('.');
    const std::string of = dot == std::string::npos ? "" : o.key.substr(0, dot);
    if (of != group) {
      group = of;
      page += fmt::format("\n## {}\n\n| key | meaning | value | range | default | source |\n|{}\n",
                          group.empty() ? "(top)" : group, "---|---|---|---|---|---|");
    }
    page += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", o.key, cell(o.meta.text), cell(o.type), cell(o.range),
                        cell(o.default_value), cell(o.meta.source));
  }
  return page;
}

std::string read(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

int main(int argc, char** argv) {
  const bool write = argc == 3 && std::string(argv[1]) == "--write";
  if (argc != 2 && !write) {
    std::cerr << "usage: reference [--write] FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[argc - 1];
  const std::vector<std::pair<std::string, std::string>> pages = {
      {"options.md", options_page()}, {"measures.md", fmt::format("{}\n\n{}", origin, jam::measures_reference())}};
  int stale = 0;
  for (const auto& [name, text] : pages) {
    if (write) {
      std::ofstream(folder / name, std::ios::binary) << text;
    } else if (read(folder / name) != text) {
      std::cerr << (folder / name).string() << " is stale; to renew it: " << argv[0] << " --write " << folder.string()
                << "\n";
      stale = 1;
    }
  }
  return stale;
}
