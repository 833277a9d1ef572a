#include "jamscape/report/pictures.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "jamscape/report/frame_choice.hpp"

namespace jam {
namespace {

constexpr std::size_t most_pictures = 10;

/// rho_c per system of the study; not a number where there is none.
std::vector<double> transitions_of(const Results& results) {
  std::vector<double> rho_c(results.study.systems.size(), std::nan(""));
  const auto table = results.table("ensemble/transitions.csv");
  if (!table) return rho_c;
  const std::vector<std::string> system = text_column(*table, "system");
  const std::vector<std::string> quantity = text_column(*table, "quantity");
  const std::vector<double> value = table->numbers("value");
  for (std::size_t k = 0; k < table->rows(); ++k)
    if (const int index = results.system(system[k]); index >= 0 && quantity[k] == "rho_c")
      rho_c[static_cast<std::size_t>(index)] = value[k];
  return rho_c;
}

/// Every planned frame; nothing unless the task is done and holds them all.
std::vector<PictureFrame> all_frames(const Task& task, const TaskFolder& folder) {
  std::vector<PictureFrame> frames;
  if (!has_all_frames(folder, task.plan)) return frames;
  const auto stored = stored_frames(RunFile(folder.run_file()), task.plan);
  for (std::size_t k = 0; k < task.plan.frames.size(); ++k)
    frames.push_back({task.plan.frames[k].packing_fraction, stored.value()[k], false});
  std::stable_sort(frames.begin(), frames.end(), [](const auto& a, const auto& b) { return a.rho < b.rho; });
  return frames;
}

std::vector<PictureFrame> chosen_frames(const std::vector<PictureFrame>& all, const std::vector<double>& wanted,
                                        double rho_c) {
  std::map<std::int64_t, double> rho, above;
  for (std::size_t k = 0; k < all.size(); ++k) {
    rho[static_cast<std::int64_t>(k)] = all[k].rho;
    if (all[k].rho >= rho_c) above[static_cast<std::int64_t>(k)] = all[k].rho;
  }
  std::map<std::int64_t, bool> chosen;  // and whether it is the system's own
  for (const std::int64_t k : wanted.empty() ? even_frames(rho, most_pictures) : nearest_frames(rho, wanted))
    chosen[k] = false;
  for (const std::int64_t k : nearest_frames(above, {rho_c})) chosen.insert({k, true});
  std::vector<PictureFrame> frames;
  for (const auto& [k, own] : chosen) {
    frames.push_back(all[static_cast<std::size_t>(k)]);
    frames.back().own = own;
  }
  return frames;
}

}  // namespace

std::vector<PictureSource> choose_pictures(const Results& results) {
  const std::vector<double> rho_c = transitions_of(results);
  std::vector<PictureSource> sources;
  for (const Task& task : list_tasks(results.study)) {
    const bool new_system = sources.empty() || sources.back().task.system != task.system;
    if (!new_system && !sources.back().frames.empty()) continue;
    const TaskFolder folder(results.folder, task.hash);
    PictureSource source{task, folder, {}, all_frames(task, folder)};
    source.frames = chosen_frames(source.all, results.study.report.pictures, rho_c[task.system]);
    if (new_system)
      sources.push_back(std::move(source));
    else
      sources.back() = std::move(source);
  }
  return sources;
}

}  // namespace jam
