// Blocks that say what was simulated and what came out in single numbers.
#include <algorithm>
#include <cmath>

#include "jamscape/base/schema.hpp"
#include "jamscape/report/blocks.hpp"
#include "jamscape/report/ensemble.hpp"
#include "jamscape/report/jamming.hpp"

namespace jam {
namespace {

Json option_value(const Option& option) {
  if (const auto* number = std::get_if<double*>(&option.target)) return rounded(**number, 8);
  if (const auto* whole = std::get_if<std::int64_t*>(&option.target)) return **whole;
  if (const auto* text = std::get_if<std::string*>(&option.target)) return **text;
  if (const auto* name = std::get_if<EnumTarget>(&option.target)) return std::string(name->names[name->get()]);
  return print_value(option);
}

/// Options of a system by key, without those that say nothing of it. The width of a size distribution that has none is
/// 0.
Json options_json(SystemOptions system) {
  Json out = Json::object();
  for (const Option& option : system_options(system)) {
    if (std::holds_alternative<std::vector<double>*>(option.target)) continue;
    out[option.key] = option_value(option);
  }
  if (system.grains.shape == BodyShape::ball || system.grains.shape == BodyShape::sphere ||
      system.grains.shape == BodyShape::custom)
    out.erase("grains.aspect");
  if (system.grains.sizes == SizeLaw::monodisperse) out["grains.width"] = 0;
  if (system.grains.sizes == SizeLaw::bidisperse) out.erase("grains.width");
  for (const StageOptions& stage : system.stages)
    if (stage.traits().moves) out["speed"] = rounded(stage.speed, 8);
  return out;
}

/// d, m and tau_c in m, kg and s; null in a study of scaled units.
Json scales_json(const Scales& scales) {
  if (scales.length == 0) return nullptr;
  return {{"length", rounded(scales.length)}, {"mass", rounded(scales.mass)}, {"time", rounded(scales.time)}};
}

/// How the relaxations of a system ended, over all frames and realisations; null where it relaxes nothing.
Json relaxations_json(const std::map<std::int64_t, RelaxationCount>& frames) {
  RelaxationCount sum;
  for (const auto& [frame, count] : frames) {
    sum.fluctuation += count.fluctuation;
    sum.energy += count.energy;
    sum.budget += count.budget;
  }
  if (sum.runs() == 0) return nullptr;
  return {{"fluctuation", sum.fluctuation}, {"energy", sum.energy}, {"budget", sum.budget}};
}

/// Frames whose energy ledger is off, over all realisations; null where there are none.
Json ledger_json(const Mark& mark) {
  if (mark.frames.empty()) return nullptr;
  std::int64_t frames = 0;
  for (const auto& [frame, runs] : mark.frames) frames += runs;
  return {{"frames", frames}, {"from", rounded(mark.from, 6)}, {"worst", rounded(mark.worst, 3)}};
}

}  // namespace

Json study_block(const Results& results) {
  const Study& study = results.study;
  std::vector<std::int64_t> done(study.systems.size(), 0);
  if (const auto table = results.table("ensemble/frames.csv")) {
    const std::vector<SystemRows> rows = ensemble_rows(results, *table, "");
    for (std::size_t k = 0; k < rows.size(); ++k) done[k] = rows[k].realisations;
  }
  std::vector<std::string> varied = varied_options(study);
  // A monodisperse system next to polydisperse ones differs in the law of sizes; people call that width 0.
  const bool widths = std::find(varied.begin(), varied.end(), "grains.width") != varied.end();
  if (widths) std::erase(varied, "grains.sizes");

  Json systems = Json::array();
  for (std::size_t k = 0; k < study.systems.size(); ++k) {
    Json options = options_json(study.systems[k].options);
    Json swept = Json::object();
    for (const std::string& key : varied)
      if (options.contains(key)) swept[key] = options[key];
    systems.push_back({{"name", study.systems[k].name},
                       {"swept", std::move(swept)},
                       {"options", std::move(options)},
                       {"realisations", done[k]},
                       {"planned", study.info.realisations},
                       {"scales", scales_json(study.systems[k].scales)},
                       {"relaxations", relaxations_json(results.relaxations[k])},
                       {"ledger", ledger_json(results.marks[k])}});
  }
  return {{"title", study.info.title.empty() ? study.info.name : study.info.title},
          {"name", study.info.name},
          {"program", "Jamscape" + (results.version.empty() ? std::string() : " " + results.version)},
          {"revision", results.commit},
          {"seed", std::to_string(study.info.seed)},
          {"swept", varied},
          {"ledger", {{"mark", rounded(study.info.ledger_mark, 6)}, {"open", study.info.ledger == LedgerRule::open}}},
          {"measure",
           {{"force", std::string(EnumNames<EdgeForce>::values[static_cast<std::size_t>(study.measure.force)].second)},
            {"clamp", rounded(study.measure.clamp)},
            {"rough_includes_edge", study.measure.rough_includes_edge}}},
          {"systems", std::move(systems)}};
}

Json transitions_block(const Results& results) {
  const auto table = results.table("ensemble/transitions.csv");
  if (!table) return nullptr;
  const std::vector<std::string> system = text_column(*table, "system");
  const std::vector<std::string> quantity = text_column(*table, "quantity");
  const std::vector<double> n = table->numbers("n");
  const std::vector<double> value = table->numbers("value");
  const std::vector<double> error = table->numbers("se");
  Json rows = Json::array();
  for (std::size_t k = 0; k < table->rows(); ++k) {
    const int index = results.system(system[k]);
    if (index < 0 || !std::isfinite(value[k])) continue;
    if (!plans_packing_fraction(results.study.systems[static_cast<std::size_t>(index)].options)) continue;
    rows.push_back({{"system", index},
                    {"quantity", quantity[k]},
                    {"n", static_cast<std::int64_t>(n[k])},
                    {"value", rounded(value[k], 7)},
                    {"se", n[k] > 1 ? rounded(error[k], 4) : Json()}});
  }
  if (rows.empty()) return nullptr;
  Json jamming = Json::array();
  for (const auto& point : jamming_points(results))
    jamming.push_back(point ? Json{{"rho", rounded(point->value, 7)}, {"quantity", point->quantity}} : Json());
  return {{"rows", std::move(rows)}, {"jamming", std::move(jamming)}};
}

}  // namespace jam
