// Quantities over packing fraction and force threshold, from ensemble/level_sets.csv.
#include <algorithm>
#include <cmath>
#include <map>

#include "jamscape/report/blocks.hpp"
#include "jamscape/report/ensemble.hpp"

namespace jam {
namespace {

struct Shown {
  const char* quantity;
  int least_dimension;
};

/// Voids need three dimensions.
constexpr Shown shown[] = {
    {"mean_cluster_pooled", 2}, {"percolating_grains", 2}, {"b0", 2}, {"b1", 2}, {"b2", 3}, {"shape", 2}};

/// Frames by packing fraction; of two at the same one the later.
std::map<double, std::int64_t> by_packing_fraction(const SystemRows& rows) {
  std::map<double, std::int64_t> frames;
  if (rows.container) return frames;
  for (const auto& [frame, at] : rows.frames) frames[at.rho] = frame;
  return frames;
}

bool has_value(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

}  // namespace

Json surfaces_block(const Results& results) {
  const auto table = results.table("ensemble/level_sets.csv");
  if (!table || table->rows() == 0) return nullptr;
  const std::vector<SystemRows> all = ensemble_rows(results, *table, "threshold");
  Json systems = Json::array();
  bool any = false;
  for (std::size_t s = 0; s < all.size(); ++s) {
    const auto by_rho = by_packing_fraction(all[s]);
    const auto at = [&](double rho) -> const EnsembleFrame& { return all[s].frames.at(by_rho.at(rho)); };
    const std::vector<double> thresholds = by_rho.empty() ? std::vector<double>() : at(by_rho.begin()->first).x;
    std::vector<double> rho;
    for (const auto& [value, frame] : by_rho)
      if (at(value).x == thresholds) rho.push_back(value);
    Json quantities = Json::object();
    for (const auto& [quantity, least_dimension] : shown) {
      if (results.study.systems[s].options.domain.dimension < least_dimension) continue;
      std::vector<double> mean, error;
      for (const double value : rho) {
        const auto& quantities_here = at(value).quantities;
        const auto found = quantities_here.find(quantity);
        if (found == quantities_here.end() || found->second.mean.size() != thresholds.size()) break;
        mean.insert(mean.end(), found->second.mean.begin(), found->second.mean.end());
        error.insert(error.end(), found->second.error.begin(), found->second.error.end());
      }
      if (mean.size() != rho.size() * thresholds.size() || !has_value(mean)) continue;
      quantities[quantity] = {{"mean", rounded(mean, 4)}, {"se", rounded(error, 2)}};
    }
    any = any || !quantities.empty();
    Json system = {
        {"rho", rounded(rho, 6)}, {"thresholds", rounded(thresholds)}, {"quantities", std::move(quantities)}};
    if (const auto& relaxed = results.relaxations[s]; !relaxed.empty()) {
      system["unrelaxed"] = Json::array();
      for (const double value : rho) system["unrelaxed"].push_back(unrelaxed_runs(relaxed, by_rho.at(value)));
    }
    systems.push_back(std::move(system));
  }
  return any ? Json{{"systems", std::move(systems)}} : Json();
}

}  // namespace jam
