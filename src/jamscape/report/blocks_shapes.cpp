// Blocks about the shape of grains: what they are, and what the final states of containers give.
#include <cmath>

#include "jamscape/geometry/cluster_shape.hpp"
#include "jamscape/io/run_file.hpp"
#include "jamscape/protocol/container.hpp"
#include "jamscape/report/blocks.hpp"
#include "jamscape/report/ensemble.hpp"
#include "jamscape/report/shape_json.hpp"

namespace jam {
namespace {

/// Lengths in d, the distances of neighbours in L; null for shapes S3 gives none for.
Json facts_json(const ClusterShape& shape) {
  const Distances at = contact_distances(shape);
  Json out = shape_json(shape);
  out["name"] = shape.name;
  out["sphericity"] = rounded(sphericity(shape));
  out["aspect"] = rounded(aspect_ratio(shape));
  out["volume"] = rounded(shape.volume);
  out["surface"] = rounded(shape.surface);
  out["area"] = rounded(shape.area);
  out["inertia"] = {rounded(shape.inertia[0]), rounded(shape.inertia[1]), rounded(shape.inertia[2])};
  out["d1"] = rounded(at.d1);
  out["d2"] = rounded(at.d2);
  out["d3"] = rounded(at.d3);
  out["j1"] = rounded(at.j1);
  return out;
}

void add_estimate(Json& quantities, const std::string& name, double value, double error) {
  if (std::isfinite(value)) quantities[name] = {{"mean", rounded(value, 6)}, {"se", rounded(error, 3)}};
}

void add_pooled(const Results& results, const Table& table, Json& systems) {
  const std::vector<std::string> system = text_column(table, "system"), quantity = text_column(table, "quantity");
  const std::vector<double> value = table.numbers("value"), error = table.numbers("se");
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const int index = results.system(system[k]);
    if (index < 0 || systems[static_cast<std::size_t>(index)].is_null()) continue;
    add_estimate(systems[static_cast<std::size_t>(index)]["quantities"], quantity[k], value[k], error[k]);
  }
}

}  // namespace

Json shape_json(const ClusterShape& shape) {
  Json arms = Json::array();
  for (const Arm& arm : shape.arms) {
    std::vector<double> numbers;
    for (int k = 0; k < 3; ++k) numbers.push_back(arm.centre[k]);
    for (int k = 0; k < 3; ++k) numbers.push_back(arm.direction[k]);
    numbers.insert(numbers.end(), {arm.half_length, arm.radius});
    arms.push_back(rounded(numbers, 7));
  }
  return {{"arms", std::move(arms)},
          {"circumradius", rounded(shape.circumradius, 7)},
          {"length", rounded(shape.length, 7)}};
}

Json final_block(const Results& results) {
  const auto table = results.table("ensemble/frames.csv");
  if (!table) return nullptr;
  Json systems = Json::array();
  bool any = false;
  for (const SystemRows& rows : ensemble_rows(results, *table, "")) {
    systems.push_back(nullptr);
    if (rows.frames.empty() || !rows.container) continue;
    Json quantities = Json::object();
    for (const auto& [name, estimates] : rows.frames.rbegin()->second.quantities)
      if (!estimates.mean.empty()) add_estimate(quantities, name, estimates.mean.front(), estimates.error.front());
    systems.back() = {{"realisations", rows.realisations}, {"quantities", std::move(quantities)}};
    any = true;
  }
  if (!any) return nullptr;
  if (const auto pooled = results.table("ensemble/transitions.csv")) add_pooled(results, *pooled, systems);
  return {{"systems", std::move(systems)}};
}

Json shapes_block(const Results& results, const std::vector<PictureSource>& sources) {
  Json systems = Json::array();
  for (std::size_t s = 0; s < results.study.systems.size(); ++s) systems.push_back(nullptr);
  bool any = false;
  for (const PictureSource& source : sources) {
    const SystemOptions& options = results.study.systems[source.task.system].options;
    std::vector<ClusterShape> found;
    if (!source.all.empty())
      found = RunFile(source.folder.run_file(), Look::structure).shapes();
    else if (options.grains.shape != BodyShape::ball)
      found = {grain_shape(options)};
    if (found.empty()) continue;
    Json shapes = Json::array();
    for (const ClusterShape& shape : found) shapes.push_back(facts_json(shape));
    systems[source.task.system] = std::move(shapes);
    any = true;
  }
  return any ? Json{{"systems", std::move(systems)}} : Json();
}

}  // namespace jam
