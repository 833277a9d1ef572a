#include "jamscape/report/jamming.hpp"

#include <cmath>
#include <map>

namespace jam {

std::vector<std::optional<JammingPoint>> jamming_points(const Results& results) {
  std::vector<std::optional<JammingPoint>> points(results.study.systems.size());
  const auto table = results.table("ensemble/transitions.csv");
  if (!table) return points;
  const std::vector<std::string> system = text_column(*table, "system");
  const std::vector<std::string> quantity = text_column(*table, "quantity");
  const std::vector<double> value = table->numbers("value");
  std::vector<std::map<std::string, double>> found(points.size());
  for (std::size_t k = 0; k < table->rows(); ++k)
    if (const int index = results.system(system[k]); index >= 0 && std::isfinite(value[k]))
      found[static_cast<std::size_t>(index)][quantity[k]] = value[k];
  for (std::size_t s = 0; s < points.size(); ++s)
    for (const char* name : {"rho_j", "rho_c", "rho_inflection"}) {
      // Three contacts a grain mean jamming for frictional discs only.
      if (std::string(name) == "rho_c" && results.study.systems[s].options.domain.dimension != 2) continue;
      if (const auto it = found[s].find(name); it != found[s].end() && !points[s]) points[s] = {it->second, name};
    }
  return points;
}

}  // namespace jam
