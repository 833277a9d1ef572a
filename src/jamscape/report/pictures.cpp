#include "jamscape/report/pictures.hpp"

#include <map>

#include "jamscape/report/frame_choice.hpp"

namespace jam {
namespace {

constexpr std::size_t most_pictures = 10;

/// Nothing unless the task is done and holds all frames the study plans.
std::vector<PictureFrame> frames_of(const Task& task, const TaskFolder& folder, const std::vector<double>& wanted) {
  if (!has_all_frames(folder, task.plan)) return {};
  const auto stored = stored_frames(RunFile(folder.run_file()), task.plan);
  std::map<std::int64_t, double> rho;
  for (std::size_t k = 0; k < task.plan.frames.size(); ++k)
    rho[static_cast<std::int64_t>(k)] = task.plan.frames[k].packing_fraction;
  std::vector<PictureFrame> frames;
  for (const std::int64_t k : wanted.empty() ? even_frames(rho, most_pictures) : nearest_frames(rho, wanted))
    frames.push_back({rho[k], stored.value()[static_cast<std::size_t>(k)]});
  return frames;
}

}  // namespace

std::vector<PictureSource> choose_pictures(const Results& results) {
  std::vector<PictureSource> sources;
  for (const Task& task : list_tasks(results.study)) {
    const bool new_system = sources.empty() || sources.back().task.system != task.system;
    if (!new_system && !sources.back().frames.empty()) continue;
    const TaskFolder folder(results.folder, task.hash);
    PictureSource source{task, folder, frames_of(task, folder, results.study.report.pictures)};
    if (new_system)
      sources.push_back(std::move(source));
    else
      sources.back() = std::move(source);
  }
  return sources;
}

}  // namespace jam
