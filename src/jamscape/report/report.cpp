#include "jamscape/report/report.hpp"

#include "jamscape/base/files.hpp"
#include "jamscape/report/blocks.hpp"
#include "jamscape/report/page.hpp"
#include "jamscape/report/plain_tables.hpp"
#include "jamscape/report/results.hpp"

namespace jam {

std::vector<LeftOut> write_report(const std::filesystem::path& results_dir) {
  return write_report(results_dir, ResultPlaces(results_dir), {});
}

std::vector<LeftOut> write_report(const std::filesystem::path& results_dir, const ResultPlaces& places,
                                  const std::vector<LeftOut>& left_out) {
  Results results = open_results(results_dir);
  results.places = places;
  results.left_out = left_out;
  Page page{
      results.study.info.title.empty() ? results.study.info.name : results.study.info.title, {}, plain_tables(results)};
  const auto add = [&page](std::string name, Json data) {
    if (!data.is_null()) page.blocks.push_back({std::move(name), std::move(data)});
  };
  add("study", study_block(results));
  add("transitions", transitions_block(results));
  add("score", score_block(results));
  add("frames", frames_block(results));
  add("columns", columns_block());
  for (const ManyChoice& choice : many_choices()) add("many-" + choice.measure, many_block(results, choice));
  add("surfaces", surfaces_block(results));
  const std::vector<PictureSource> pictures = choose_pictures(results);
  add("final", final_block(results));
  const Json shapes = shapes_block(results, pictures);
  if (!shapes.is_null()) add("conzelmann", conzelmann_block());
  add("shapes", shapes);
  add("networks", networks_block(pictures, results.study.measure));
  add("diagrams", diagrams_block(pictures, results.study.measure));
  write_text(results_dir / "report.html", print_page(page));
  std::vector<LeftOut> damaged;
  for (const PictureSource& source : pictures)
    damaged.insert(damaged.end(), source.damaged.begin(), source.damaged.end());
  return damaged;
}

}  // namespace jam
