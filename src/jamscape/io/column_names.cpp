#include "jamscape/io/column_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "jamscape/base/error.hpp"
#include "jamscape/base/nearest.hpp"
#include "jamscape/io/number_text.hpp"

namespace jam {
namespace {

std::string advice(const CsvFile& csv, const ColumnNames& names) {
  const auto& there = csv.columns();
  if (std::all_of(there.begin(), there.end(), [](const auto& name) { return parse_double(name).has_value(); }))
    return fmt::format("the first row holds numbers: put a row of names above it, with '{}' among them{}", names[0],
                       csv.remarks().empty() ? "" : " (a line that begins with # is a remark)");
  std::string best;
  std::size_t best_distance = std::string::npos;
  for (const std::string& name : there) {
    const std::string meant = nearest(lower_case(name), names);
    if (meant.size() < 2 || name.size() < 2) continue;  // any two letters are near each other
    if (const std::size_t distance = edit_distance(lower_case(name), meant); distance < best_distance) {
      best = fmt::format("did you mean '{}' by '{}'?", meant, name);
      best_distance = distance;
    }
  }
  if (!best.empty()) return best;
  return fmt::format("name it {}; there are: {}", fmt::join(names, " or "), fmt::join(there, ", "));
}

}  // namespace

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::optional<std::size_t> find_column(const CsvFile& csv, const ColumnNames& names) {
  for (const std::string& name : names)
    for (std::size_t c = 0; c < csv.columns().size(); ++c)
      if (lower_case(csv.columns()[c]) == name) return c;
  return {};
}

std::size_t need_column(const CsvFile& csv, const ColumnNames& names, const std::string& what) {
  if (const auto found = find_column(csv, names)) return *found;
  throw data_error(fmt::format("there is no column '{}' ({})", names[0], what), csv.place_of_header(),
                   advice(csv, names));
}

}  // namespace jam
