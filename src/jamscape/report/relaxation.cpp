#include "jamscape/report/relaxation.hpp"

#include <string>

#include "jamscape/protocol/relaxation.hpp"
#include "jamscape/report/results.hpp"

namespace jam {

std::int64_t unrelaxed_runs(const std::map<std::int64_t, RelaxationCount>& system, std::int64_t frame) {
  const auto found = system.find(frame);
  return found == system.end() ? 0 : found->second.budget;
}

Relaxations count_relaxations(const Study& study, const Table& frames) {
  Relaxations systems(study.systems.size());
  if (!frames.has("relaxation")) return systems;
  const std::vector<std::string> name = text_column(frames, "system");
  const std::vector<std::string> ended = text_column(frames, "relaxation");
  const std::vector<double> frame = frames.numbers("frame");
  std::map<std::string, std::size_t> index;
  for (std::size_t s = 0; s < study.systems.size(); ++s) index[study.systems[s].name] = s;
  for (std::size_t k = 0; k < frames.rows(); ++k) {
    const auto system = index.find(name[k]);
    if (system == index.end()) continue;
    const auto count = [&]() -> RelaxationCount& {
      return systems[system->second][static_cast<std::int64_t>(frame[k])];
    };
    if (ended[k] == relaxed_fluctuation)
      ++count().fluctuation;
    else if (ended[k] == relaxed_energy)
      ++count().energy;
    else if (ended[k] == not_relaxed)
      ++count().budget;
  }
  return systems;
}

}  // namespace jam
