#include "jamscape/study/states.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace jam {

States find_states(std::span<const FrameKind> frames) {
  std::map<std::string, std::size_t> count;
  std::set<std::string> relaxing;
  for (const FrameKind& f : frames) {
    ++count[f.stage];
    if (f.relaxed) relaxing.insert(f.stage);
  }
  std::vector<std::size_t> relaxed, moving;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    if (frames[k].relaxed) relaxed.push_back(k);
    if (!relaxing.contains(frames[k].stage) && (relaxing.empty() || count[frames[k].stage] > 1)) moving.push_back(k);
  }
  if (!relaxed.empty() && relaxed.size() >= moving.size()) return {relaxed, true};
  const std::size_t curve = moving.size();
  for (const std::size_t r : relaxed) {
    const auto same = [&](std::size_t m) {
      return std::abs(frames[m].packing_fraction - frames[r].packing_fraction) < 1e-9;
    };
    if (std::none_of(moving.begin(), moving.begin() + static_cast<std::ptrdiff_t>(curve), same)) moving.push_back(r);
  }
  std::sort(moving.begin(), moving.end());
  return {moving, false};
}

}  // namespace jam
