#include "read_network.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

namespace jam::examples {

WeightedGraph read_network(const std::filesystem::path& file) {
  // zlib reads plain files as they are
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> in(gzopen(file.c_str(), "rb"), gzclose);
  if (!in) throw std::runtime_error("cannot open " + file.string());
  WeightedGraph g;
  char line[512];
  bool counted = false;
  for (int number = 1; gzgets(in.get(), line, sizeof line) != nullptr; ++number) {
    unsigned i = 0, j = 0;
    double force = 0;
    if (line[0] == '#') {
      counted = std::sscanf(line, "# vertices: %u", &g.vertices) == 1 || counted;
    } else if (std::sscanf(line, "%u,%u,%lf", &i, &j, &force) == 3) {
      g.from.push_back(i);
      g.to.push_back(j);
      g.weight.push_back(force);
    } else if (!std::string(line).starts_with("i,j,force")) {
      throw std::runtime_error(fmt::format("{}:{}: expected i,j,force", file.string(), number));
    }
  }
  int error = Z_OK;
  gzerror(in.get(), &error);
  if (error != Z_OK) throw std::runtime_error("truncated or damaged: " + file.string());
  if (!counted) throw std::runtime_error(file.string() + ": no comment `# vertices: N`");
  return g;
}

}  // namespace jam::examples
