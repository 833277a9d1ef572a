#include "jamscape/report/frame_choice.hpp"

#include <algorithm>
#include <cmath>

namespace jam {

std::vector<std::int64_t> even_frames(const std::map<std::int64_t, double>& rho, std::size_t most) {
  std::map<double, std::int64_t> by_rho;
  for (const auto& [frame, value] : rho) by_rho[value] = frame;
  std::vector<std::int64_t> multiples, all;
  for (const auto& [value, frame] : by_rho) {
    all.push_back(frame);
    if (std::abs(value / 0.02 - std::round(value / 0.02)) < 1e-6) multiples.push_back(frame);
  }
  if (multiples.size() >= 3) {
    if (multiples.size() > most)
      multiples.erase(multiples.begin(), multiples.end() - static_cast<std::ptrdiff_t>(most));
    return multiples;
  }
  if (all.size() <= most) return all;
  std::vector<std::int64_t> spaced;
  for (std::size_t k = 0; k < most; ++k) spaced.push_back(all[k * (all.size() - 1) / (most - 1)]);
  return spaced;
}

std::vector<std::int64_t> last_frame(const std::map<std::int64_t, double>& rho) {
  if (rho.empty()) return {};
  const auto largest =
      std::max_element(rho.begin(), rho.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return {largest->first};
}

std::vector<std::int64_t> nearest_frames(const std::map<std::int64_t, double>& rho, const std::vector<double>& wanted) {
  std::vector<std::int64_t> out;
  for (const double value : wanted) {
    const auto nearest = std::min_element(rho.begin(), rho.end(), [value](const auto& a, const auto& b) {
      return std::abs(a.second - value) < std::abs(b.second - value);
    });
    if (nearest != rho.end() && std::find(out.begin(), out.end(), nearest->first) == out.end())
      out.push_back(nearest->first);
  }
  return out;
}

}  // namespace jam
