// Blocks of curves: quantities over packing fraction, and measures with several rows a frame.
#include <algorithm>
#include <cmath>
#include <set>

#include "jamscape/observe/measure.hpp"
#include "jamscape/report/blocks.hpp"
#include "jamscape/report/ensemble.hpp"
#include "jamscape/report/frame_choice.hpp"

namespace jam {
namespace {

bool any_finite(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

Json estimate_json(const Estimates& estimates, std::size_t rows) {
  const auto head = [rows](const std::vector<double>& values) {
    return std::vector<double>(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rows));
  };
  return {{"mean", rounded(head(estimates.mean), 5)}, {"se", rounded(head(estimates.error), 3)}};
}

}  // namespace

Json frames_block(const Results& results) {
  const auto table = results.table("ensemble/frames.csv");
  if (!table) return nullptr;
  Json systems = Json::array();
  bool any = false;
  for (const SystemRows& rows : ensemble_rows(results, *table, "")) {
    // Two stages may stop at the same packing fraction: the later frame is shown.
    std::map<double, const FrameRows*> by_rho;
    std::set<std::string> names;
    for (const auto& [frame, at] : rows.frames) {
      by_rho[at.rho] = &at;
      for (const auto& [name, estimates] : at.quantities) names.insert(name);
    }
    std::vector<double> rho;
    for (const auto& [value, at] : by_rho) rho.push_back(value);
    Json quantities = Json::object();
    for (const std::string& name : names) {
      Estimates curve;
      for (const auto& [value, at] : by_rho) {
        const auto found = at->quantities.find(name);
        const bool have = found != at->quantities.end() && !found->second.mean.empty();
        curve.mean.push_back(have ? found->second.mean.front() : std::nan(""));
        curve.error.push_back(have ? found->second.error.front() : std::nan(""));
      }
      if (any_finite(curve.mean)) quantities[name] = estimate_json(curve, rho.size());
    }
    any = any || !quantities.empty();
    systems.push_back({{"rho", rounded(rho, 6)}, {"quantities", std::move(quantities)}});
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
  return {{"force_distribution", FrameChoice::even, 0.7599, 6.2},
          {"pair_correlation", FrameChoice::last, 0, 8},
          {"betti", FrameChoice::even, 0.6999, 5}};
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
  for (const SystemRows& rows : ensemble_rows(results, *table, abscissa)) {
    std::map<std::int64_t, double> rhos;
    for (const auto& [frame, at] : rows.frames)
      if (at.rho >= choice.from) rhos[frame] = at.rho;
    const std::vector<std::int64_t> wanted =
        choice.frames == FrameChoice::even ? even_frames(rhos, 16) : last_frame(rhos);
    Json frames = Json::array();
    for (const std::int64_t frame : wanted) {
      const FrameRows& at = rows.frames.at(frame);
      const auto rows_shown = static_cast<std::size_t>(
          std::upper_bound(at.x.begin(), at.x.end(), choice.longest * (1 + 1e-9)) - at.x.begin());
      std::vector<double> x(at.x.begin(), at.x.begin() + static_cast<std::ptrdiff_t>(rows_shown));
      Json quantities = Json::object();
      for (const auto& [name, estimates] : at.quantities)
        if (estimates.mean.size() == at.x.size()) quantities[name] = estimate_json(estimates, rows_shown);
      frames.push_back({{"rho", rounded(at.rho, 6)}, {"x", rounded(x)}, {"quantities", std::move(quantities)}});
    }
    any = any || !frames.empty();
    systems.push_back({{"frames", std::move(frames)}});
  }
  return any ? Json{{"systems", std::move(systems)}} : Json();
}

}  // namespace jam
