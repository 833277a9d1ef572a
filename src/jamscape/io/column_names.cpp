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

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string advice(const CsvFile& csv, const ColumnNames& names) {
  const auto& there = csv.columns();
  if (std::all_of(there.begin(), there.end(), [](const auto& name) { return parse_double(name).has_value(); }))
    return fmt::format("the first row holds numbers: put a row of names above it, with '{}' among them", names[0]);
  if (there.size() == 1 && there[0].find_first_of(";\t ") != std::string::npos) return "separate the columns by commas";
  std::string best;
  std::size_t best_distance = std::string::npos;
  for (const std::string& name : there) {
    const std::string meant = nearest(lower(name), names);
    if (meant.size() < 2 || name.size() < 2) continue;  // any two letters are near each other
    if (const std::size_t distance = edit_distance(lower(name), meant); distance < best_distance) {
      best = fmt::format("did you mean '{}' by '{}'?", meant, name);
      best_distance = distance;
    }
  }
  if (!best.empty()) return best;
  return fmt::format("name it {}; there are: {}", fmt::join(names, " or "), fmt::join(there, ", "));
}

}  // namespace

std::optional<std::size_t> find_column(const CsvFile& csv, const ColumnNames& names) {
  for (const std::string& name : names)
    for (std::size_t c = 0; c < csv.columns().size(); ++c)
      if (lower(csv.columns()[c]) == name) return c;
  return {};
}

std::size_t need_column(const CsvFile& csv, const ColumnNames& names, const std::string& what) {
  if (const auto found = find_column(csv, names)) return *found;
  throw data_error(fmt::format("there is no column '{}' ({})", names[0], what), csv.file(), advice(csv, names));
}

}  // namespace jam
