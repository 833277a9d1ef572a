// Blocks of curves: quantities over packing fraction, and measures with several rows a frame.
#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "jamscape/observe/measure.hpp"
#include "jamscape/report/blocks.hpp"
#include "jamscape/report/ensemble.hpp"
#include "jamscape/report/frame_choice.hpp"

namespace jam {
namespace {

bool any_finite(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

/// Columns that say nothing in so many dimensions: order of hexagons in three, voids in two.
bool says_nothing(std::string_view column, std::int64_t dimension) {
  if (dimension == 3) return column.starts_with("psi6");
  return column == "tp2" || column == "b2" || column.starts_with("b2_") || column == "percolates_z";
}

Json estimate_json(const Estimates& estimates, std::size_t rows) {
  const auto head = [rows](const std::vector<double>& values) {
    return std::vector<double>(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rows));
  };
  return {{"mean", rounded(head(estimates.mean), 5)}, {"se", rounded(head(estimates.error), 3)}};
}

std::vector<std::int64_t> chosen_frames(const SystemRows& rows, FrameChoice choice, double from) {
  if (rows.container || choice == FrameChoice::final) {
    if (rows.frames.empty()) return {};
    return {rows.frames.rbegin()->first};
  }
  std::map<std::int64_t, double> rhos;
  for (const auto& [frame, at] : rows.frames)
    if (at.rho >= from) rhos[frame] = at.rho;
  return choice == FrameChoice::even ? even_frames(rhos, 16) : last_frame(rhos);
}

}  // namespace

Json frames_block(const Results& results) {
  const auto table = results.table("ensemble/frames.csv");
  if (!table) return nullptr;
  Json systems = Json::array();
  bool any = false;
  const std::vector<SystemRows> all = ensemble_rows(results, *table, "");
  for (std::size_t s = 0; s < all.size(); ++s) {
    const SystemRows& rows = all[s];
    const std::int64_t dimension = results.study.systems[s].options.domain.dimension;
    // Two stages may stop at the same packing fraction: the later frame is shown.
    std::map<double, std::int64_t> by_rho;
    std::set<std::string> names;
    for (const auto& [frame, at] : rows.frames) {
      if (rows.container) break;
      by_rho[at.rho] = frame;
      for (const auto& [name, estimates] : at.quantities)
        if (!says_nothing(name, dimension)) names.insert(name);
    }
    std::vector<double> rho;
    for (const auto& [value, frame] : by_rho) rho.push_back(value);
    Json quantities = Json::object();
    for (const std::string& name : names) {
      Estimates curve;
      for (const auto& [value, frame] : by_rho) {
        const auto& at = rows.frames.at(frame);
        const auto found = at.quantities.find(name);
        const bool have = found != at.quantities.end() && !found->second.mean.empty();
        curve.mean.push_back(have ? found->second.mean.front() : std::nan(""));
        curve.error.push_back(have ? found->second.error.front() : std::nan(""));
      }
      if (any_finite(curve.mean)) quantities[name] = estimate_json(curve, rho.size());
    }
    any = any || !quantities.empty();
    Json system = {{"rho", rounded(rho, 6)}, {"quantities", std::move(quantities)}};
    if (const auto& relaxed = results.relaxations[s]; !relaxed.empty()) {
      system["unrelaxed"] = Json::array();
      for (const auto& [value, frame] : by_rho) system["unrelaxed"].push_back(unrelaxed_runs(relaxed, frame));
    }
    if (const auto& marked = results.marks[s].frames; !marked.empty()) {
      system["marked"] = Json::array();
      for (const auto& [value, frame] : by_rho)
        system["marked"].push_back(marked.contains(frame) ? marked.at(frame) : 0);
    }
    systems.push_back(std::move(system));
  }
  return any ? Json{{"systems", std::move(systems)}} : Json();
}

Json columns_block() {
  Json columns = Json::object();
  for (const Measure& measure : measures()) {
    if (measure.rows != Rows::frame) continue;
    for (const ColumnInfo& column : measure.columns)
      columns[column.name] = {
          {"text", column.text}, {"unit", column.unit}, {"formula", measure.formula}, {"source", measure.source}};
  }
  return columns;
}

std::vector<ManyChoice> many_choices() {
  return {{"force_distribution", FrameChoice::even, 0.7599, 0.4999, 6.2},
          {"pair_correlation", FrameChoice::densest, 0, 0, 8},
          {"betti", FrameChoice::even, 0.6999, 0.4499, 5},
          {"contact_force_distribution", FrameChoice::final, 0, 0, 10},
          {"stress_distribution", FrameChoice::final, 0, 0, 10},
          {"radial_distribution", FrameChoice::final, 0, 0, 4}};
}

Json many_block(const Results& results, const ManyChoice& choice) {
  const auto table = results.table("ensemble/" + choice.measure + ".csv");
  if (!table || table->rows() == 0) return nullptr;
  // The abscissa stands right before "quantity".
  std::string abscissa;
  for (const Column& column : table->columns) {
    if (column.name == "quantity") break;
    abscissa = column.name;
  }
  Json systems = Json::array();
  bool any = false;
  const std::vector<SystemRows> all = ensemble_rows(results, *table, abscissa);
  for (std::size_t s = 0; s < all.size(); ++s) {
    const SystemRows& rows = all[s];
    const std::int64_t dimension = results.study.systems[s].options.domain.dimension;
    const double from = dimension == 3 ? choice.from_3d : choice.from;
    Json frames = Json::array();
    for (const std::int64_t frame : chosen_frames(rows, choice.frames, from)) {
      const EnsembleFrame& at = rows.frames.at(frame);
      const auto rows_shown = static_cast<std::size_t>(
          std::upper_bound(at.x.begin(), at.x.end(), choice.longest * (1 + 1e-9)) - at.x.begin());
      std::vector<double> x(at.x.begin(), at.x.begin() + static_cast<std::ptrdiff_t>(rows_shown));
      Json quantities = Json::object();
      for (const auto& [name, estimates] : at.quantities)
        if (estimates.mean.size() == at.x.size() && !says_nothing(name, dimension))
          quantities[name] = estimate_json(estimates, rows_shown);
      frames.push_back({{"rho", rounded(at.rho, 6)}, {"x", rounded(x)}, {"quantities", std::move(quantities)}});
    }
    any = any || !frames.empty();
    systems.push_back({{"frames", std::move(frames)}});
  }
  return any ? Json{{"systems", std::move(systems)}} : Json();
}

}  // namespace jam
