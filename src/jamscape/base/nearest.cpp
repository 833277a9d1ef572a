#include "jamscape/base/nearest.hpp"

#include <algorithm>

namespace jam {
namespace {

std::string_view last_part(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string_view::npos ? name : name.substr(dot + 1);
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) above[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(above);
    above.swap(row);
  }
  return above[b.size()];
}

std::string nearest(std::string_view typed, const std::vector<std::string>& known) {
  std::string best;
  std::size_t best_score = std::string::npos;
  const auto offer = [&](const std::string& name, std::size_t score) {
    if (score < best_score) best = name, best_score = score;
  };
  for (const std::string& name : known) {
    const std::size_t whole = edit_distance(typed, name);
    if (whole <= 1 + std::max(typed.size(), name.size()) / 4) offer(name, 2 * whole);
    if (name.find('.') == std::string::npos) continue;
    const std::string_view part = last_part(name);
    const std::size_t apart = edit_distance(last_part(typed), part);
    if (apart <= 1 + part.size() / 4) offer(name, 2 * apart + 3);  // as if the group were one and a half letters off
  }
  return best;
}

}  // namespace jam
