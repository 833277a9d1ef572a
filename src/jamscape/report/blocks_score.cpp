// Published values beside ours, for a study that names its targets.
#include <algorithm>
#include <string>

#include "jamscape/base/error.hpp"
#include "jamscape/report/blocks.hpp"
#include "jamscape/study/builtin.hpp"
#include "jamscape/study/score.hpp"

namespace jam {
namespace {

Json row_json(const Score& score) {
  return {{"target", score.target},
          {"source", score.source},
          {"systems", score.systems},
          {"published", score.published},
          {"ours", rounded(score.ours, 6)},
          {"error", rounded(score.error, 3)},
          {"n", score.n},
          {"needed", score.needed},
          {"verdict", verdict_name(score.verdict)},
          {"note", score.note}};
}

}  // namespace

Json score_block(const Results& results) {
  const Study& study = results.study;
  const std::string name = study.info.targets + ".targets.toml";
  const std::string_view text = study.info.targets.empty() ? std::string_view() : builtin_file(name);
  if (text.empty()) return nullptr;
  const std::vector<Target> targets = read_targets(text, name);
  const std::vector<Task> tasks = stored_tasks(study, results.places.results);
  const std::vector<DoneTask> done = find_done(study, tasks, results.places, results.left_out);
  if (done.empty()) return nullptr;

  Json rows = Json::array();
  for (const Score& score : score_targets(targets, study, done)) rows.push_back(row_json(score));
  if (rows.empty()) return nullptr;

  // Published points of jamming, so that they can stand beside ours whatever the verdict.
  std::vector<Target> values;
  std::copy_if(targets.begin(), targets.end(), std::back_inserter(values), [](const Target& t) {
    return t.is_value() && (t.left.quantity == "rho_c" || t.left.quantity == "rho_j");
  });
  Json published = Json::array();
  for (const Target& value : values)
    for (const Score& score : score_targets({value}, study, done))
      if (const int system = results.system(score.systems); system >= 0)
        published.push_back({{"system", system}, {"value", rounded(value.right.value, 6)}});
  return {{"rows", std::move(rows)}, {"published", std::move(published)}};
}

}  // namespace jam
