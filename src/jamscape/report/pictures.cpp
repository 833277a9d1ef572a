#include "jamscape/report/pictures.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "jamscape/base/error.hpp"
#include "jamscape/io/seal.hpp"
#include "jamscape/report/frame_choice.hpp"
#include "jamscape/report/jamming.hpp"
#include "jamscape/study/done_tasks.hpp"

namespace jam {
namespace {

/// Fewer pictures of larger packings, so that the page stays small.
std::size_t most_pictures(std::int64_t grains) {
  constexpr std::int64_t grains_shown = 40000;
  return static_cast<std::size_t>(std::clamp<std::int64_t>(grains_shown / std::max<std::int64_t>(grains, 1), 3, 10));
}

/// The last frames of a container; few, since clusters take more room than spheres.
std::vector<PictureFrame> container_frames(const std::vector<PictureFrame>& all, std::int64_t grains) {
  const std::size_t most = grains <= 5000 ? 3 : 1;
  return {all.end() - static_cast<std::ptrdiff_t>(std::min(all.size(), most)), all.end()};
}

/// Every planned frame, or those after a relaxation where there are any; nothing unless the task is done and holds them
/// all.
std::vector<PictureFrame> all_frames(const Results& results, const Task& task, const TaskFolder& folder) {
  std::vector<PictureFrame> frames;
  if (is_left_out(results.left_out, task.hash) || !has_all_frames(folder, task.plan)) return frames;
  const RunFile run(folder.run_file(), Look::structure);
  const auto stored = stored_frames(run, task.plan);
  if (!plans_packing_fraction(results.study.systems[task.system].options)) {
    for (std::size_t k = 0; k < task.plan.frames.size(); ++k) {
      const std::size_t at = stored.value()[k];
      frames.push_back({run.packing_fractions()[at], at, false, task.plan.frames[k].stage});
    }
    return frames;
  }
  const auto& states = results.states[task.system];
  for (std::size_t k = 0; k < task.plan.frames.size(); ++k)
    if (states.empty() || states.contains(static_cast<std::int64_t>(k)))
      frames.push_back({task.plan.frames[k].packing_fraction, stored.value()[k], false});
  std::stable_sort(frames.begin(), frames.end(), [](const auto& a, const auto& b) { return a.rho < b.rho; });
  return frames;
}

/// Why the chosen frames of a run without a seal cannot be read, or ""; those with one were looked at before.
std::string unreadable(const PictureSource& source) try {
  if (source.frames.empty() || ends_in_seal(source.folder.run_file())) return {};
  const RunFile run(source.folder.run_file(), Look::structure);
  for (const PictureFrame& frame : source.frames) run.frame(frame.stored);
  return {};
} catch (const Error& error) {
  return error.what();
}

/// The packing fractions asked for that a system comes to, a step of the usual size aside.
std::vector<double> reached(std::vector<double> wanted, const std::map<std::int64_t, double>& rho) {
  constexpr double step = 0.02;
  if (rho.empty()) return wanted;
  double least = rho.begin()->second, most = least;
  for (const auto& [frame, value] : rho) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  std::erase_if(wanted, [&](double value) { return value < least - step || value > most + step; });
  return wanted;
}

std::vector<PictureFrame> chosen_frames(const std::vector<PictureFrame>& all, const std::vector<double>& wanted,
                                        std::size_t most, std::optional<JammingPoint> jamming) {
  const double rho_c = jamming ? jamming->value : std::nan("");
  std::map<std::int64_t, double> rho, above;
  for (std::size_t k = 0; k < all.size(); ++k) {
    rho[static_cast<std::int64_t>(k)] = all[k].rho;
    if (all[k].rho >= rho_c) above[static_cast<std::int64_t>(k)] = all[k].rho;
  }
  std::map<std::int64_t, bool> chosen;  // and whether it is the system's own
  const std::vector<double> asked = reached(wanted, rho);
  for (const std::int64_t k : asked.empty() ? even_frames(rho, most) : nearest_frames(rho, asked)) chosen[k] = false;
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
  const auto jamming = jamming_points(results);
  std::vector<PictureSource> sources;
  for (const Task& task : stored_tasks(results.study, results.places.results)) {
    const bool new_system = sources.empty() || sources.back().task.system != task.system;
    if (!new_system && !sources.back().frames.empty()) continue;
    const TaskFolder folder = folder_with_rows(results.places, task.hash, {&find_measure("diagram")});
    PictureSource source{task, folder, {}, all_frames(results, task, folder)};
    const SystemOptions& options = results.study.systems[task.system].options;
    source.frames = plans_packing_fraction(options)
                        ? chosen_frames(source.all, results.study.report.pictures, most_pictures(options.grains.count),
                                        jamming[task.system])
                        : container_frames(source.all, options.grains.count);
    if (!new_system) source.damaged = std::move(sources.back().damaged);
    if (std::string reason = unreadable(source); !reason.empty()) {
      source.frames.clear(), source.all.clear();
      source.damaged.push_back({task.hash, std::move(reason)});
    }
    if (new_system)
      sources.push_back(std::move(source));
    else
      sources.back() = std::move(source);
  }
  return sources;
}

}  // namespace jam
