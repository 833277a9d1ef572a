#include "jamscape/report/ensemble.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace jam {

std::vector<SystemRows> ensemble_rows(const Results& results, const Table& table, const std::string& abscissa) {
  std::vector<SystemRows> systems(results.study.systems.size());
  for (std::size_t s = 0; s < systems.size(); ++s)
    systems[s].container = !plans_packing_fraction(results.study.systems[s].options);
  const std::vector<std::string> name = text_column(table, "system");
  const std::vector<std::string> quantity = text_column(table, "quantity");
  const std::vector<double> frame = table.numbers("frame");
  const std::vector<double> rho = table.numbers("packing_fraction_target");
  const std::vector<double> n = table.numbers("n");
  const std::vector<double> mean = table.numbers("mean");
  const std::vector<double> error = table.numbers("se");
  const std::vector<double> x = abscissa.empty() ? std::vector<double>() : table.numbers(abscissa);
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const int system = results.system(name[k]);
    if (system < 0) continue;
    const auto& states = results.states[static_cast<std::size_t>(system)];
    if (!states.empty() && !states.contains(static_cast<std::int64_t>(frame[k]))) continue;
    SystemRows& rows = systems[static_cast<std::size_t>(system)];
    rows.realisations = std::max(rows.realisations, static_cast<std::int64_t>(n[k]));
    EnsembleFrame& at = rows.frames[static_cast<std::int64_t>(frame[k])];
    at.rho = rho[k];
    if (at.quantities.empty()) at.first = quantity[k];
    Estimates& estimates = at.quantities[quantity[k]];
    if (!x.empty() && quantity[k] == at.first) at.x.push_back(x[k]);
    estimates.mean.push_back(mean[k]);
    estimates.error.push_back(n[k] > 1 ? error[k] : std::numeric_limits<double>::quiet_NaN());
  }
  return systems;
}

}  // namespace jam
