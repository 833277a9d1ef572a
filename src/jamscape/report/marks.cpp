#include "jamscape/report/marks.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "jamscape/report/results.hpp"
#include "jamscape/study/states.hpp"

namespace jam {
namespace {

std::map<std::string, std::size_t> index_of(const Study& study) {
  std::map<std::string, std::size_t> index;
  for (std::size_t s = 0; s < study.systems.size(); ++s) index[study.systems[s].name] = s;
  return index;
}

std::vector<double> packing_fractions(const Table& frames) {
  constexpr const char* column = "packing_fraction_target";
  return frames.has(column) ? frames.numbers(column)
                            : std::vector<double>(frames.rows(), std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

FrameSets frames_of_curves(const Study& study, const Table& frames) {
  FrameSets sets(study.systems.size());
  if (!frames.has("relaxation") || !frames.has("stage")) return sets;
  const auto index = index_of(study);
  const std::vector<std::string> name = text_column(frames, "system"), stage = text_column(frames, "stage"),
                                 ended = text_column(frames, "relaxation");
  const std::vector<double> frame = frames.numbers("frame"), rho = packing_fractions(frames);
  std::vector<std::map<std::int64_t, FrameKind>> kinds(study.systems.size());
  for (std::size_t k = 0; k < frames.rows(); ++k)
    if (const auto system = index.find(name[k]); system != index.end())
      kinds[system->second].insert({static_cast<std::int64_t>(frame[k]), {stage[k], rho[k], !ended[k].empty()}});
  for (std::size_t s = 0; s < sets.size(); ++s) {
    std::vector<std::int64_t> numbers;
    std::vector<FrameKind> list;
    for (const auto& [number, kind] : kinds[s]) numbers.push_back(number), list.push_back(kind);
    if (std::none_of(list.begin(), list.end(), [](const FrameKind& f) { return f.relaxed; })) continue;
    for (const std::size_t k : find_states(list).frames) sets[s].insert(numbers[k]);
  }
  return sets;
}

Marks count_marks(const Study& study, const Table& frames) {
  Marks marks(study.systems.size());
  if (!frames.has("marked") || !frames.has("ledger_error")) return marks;
  const auto index = index_of(study);
  const std::vector<std::string> name = text_column(frames, "system");
  const std::vector<double> frame = frames.numbers("frame"), rho = packing_fractions(frames),
                            marked = frames.numbers("marked"), error = frames.numbers("ledger_error");
  for (std::size_t k = 0; k < frames.rows(); ++k) {
    const auto system = index.find(name[k]);
    if (system == index.end() || !(marked[k] > 0)) continue;
    Mark& mark = marks[system->second];
    mark.from = mark.frames.empty() ? rho[k] : std::min(mark.from, rho[k]);
    mark.worst = std::max(mark.worst, error[k]);
    ++mark.frames[static_cast<std::int64_t>(frame[k])];
  }
  return marks;
}

}  // namespace jam
