#include "jamscape/io/leading_lines.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "jamscape/base/error.hpp"
#include "jamscape/base/nearest.hpp"
#include "jamscape/base/printable.hpp"
#include "jamscape/io/column_names.hpp"
#include "jamscape/io/vector_columns.hpp"

namespace jam {
namespace {

bool holds(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// What others call the box.
const std::vector<std::string> box_words{"box",  "boundary", "boundaries", "bounds", "pbc", "periodicity", "lattice",
                                         "cell", "xlo",      "xhi",        "ylo",    "yhi", "box_size",    "boxsize",
                                         "low",  "high",     "lx",         "ly",     "lz"};

constexpr const char* box_advice = "give the box as '# lo: x y z', '# hi: x y z' and '# periodic: 1 1 0'";

std::string example(const std::string& key) {
  if (key == "periodic") return "# periodic: 1 1 0";
  if (key == "lo" || key == "hi") return fmt::format("# {}: x y z", key);
  return fmt::format("# {}: value", key);
}

/// The first word of a remark, without the signs that may stand in place of a colon.
std::string first_word(std::string_view text) {
  const auto end = std::min(text.size(), text.find_first_of(" \t=,;"));
  return lower_case(std::string(text.substr(0, end)));
}

/// A remark is prose unless numbers or yes and no follow its first word.
bool values_follow(std::string_view text) {
  const auto start = text.find_first_of(" \t=,;");
  if (start == std::string_view::npos) return false;
  const auto value = text.find_first_not_of(" \t=,;", start);
  if (value == std::string_view::npos) return false;
  const std::string rest = first_word(text.substr(value));
  return std::string_view("0123456789+-.").find(rest[0]) != std::string_view::npos || rest == "true" ||
         rest == "false" || rest == "yes" || rest == "no" || rest == "t" || rest == "f" || rest == "p";
}

/// The name that a key resembles: one letter off in four. Short names resemble too much.
std::string resembled(const std::string& key, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (name.size() > 2 && edit_distance(key, name) <= std::max<std::size_t>(1, name.size() / 4)) return name;
  return key == "dim" ? "dimension" : "";
}

std::string shown(const std::string& text) { return printable(text.substr(0, 40), LineEnds::escape); }

}  // namespace

LeadingLines::LeadingLines(const CsvFile& csv, const KnownKeys& known, std::vector<std::string>& notes) : csv_(csv) {
  std::vector<std::string> seen, unused;
  for (const CsvRemark& line : csv.remarks()) {
    const bool keyed = !line.key.empty();
    if (!keyed && !values_follow(line.value)) continue;
    const std::string key = keyed ? lower_case(line.key) : first_word(line.value);
    if (keyed && holds(known.here, key)) {
      if (holds(known.once, key) && holds(seen, key))
        throw data_error(fmt::format("the line '# {}' is given twice", key), line.place, "keep one of them");
      seen.push_back(key);
      continue;
    }
    if (holds(known.elsewhere, key))
      throw data_error(fmt::format("the line '# {}' has no meaning here", key), line.place,
                       fmt::format("move it to the {}", known.other_table));
    if (holds(box_words, key))
      throw data_error(fmt::format("the line '# {}' is not understood", shown(keyed ? line.key : line.value)),
                       line.place, box_advice);
    if (!keyed && holds(known.here, key))
      throw data_error(fmt::format("the line '# {}' has no colon", shown(line.value)), line.place,
                       fmt::format("write it as '{}'", example(key)));
    if (const std::string meant = resembled(key, known.consequential); !meant.empty())
      throw data_error(fmt::format("the line '# {}' is not understood", shown(keyed ? line.key : line.value)),
                       line.place, fmt::format("did you mean '{}'?", example(meant)));
    if (keyed && !holds(unused, line.key)) unused.push_back(shown(line.key));
  }
  if (!unused.empty()) notes.push_back(fmt::format("lines that nothing reads: # {}", fmt::join(unused, ", # ")));
}

const CsvRemark* LeadingLines::find(std::string_view key) const {
  for (const CsvRemark& line : csv_.remarks())
    if (lower_case(line.key) == key) return &line;
  return nullptr;
}

std::vector<const CsvRemark*> LeadingLines::all(std::string_view key) const {
  std::vector<const CsvRemark*> lines;
  for (const CsvRemark& line : csv_.remarks())
    if (lower_case(line.key) == key) lines.push_back(&line);
  return lines;
}

std::optional<std::vector<double>> LeadingLines::numbers(std::string_view key, std::size_t count) const {
  const CsvRemark* line = find(key);
  if (line == nullptr) return {};
  const auto found = parse_numbers(line->value, count);
  if (!found)
    throw data_error(fmt::format("the line '# {}: {}' should hold {} number{}", key, shown(line->value), count,
                                 count == 1 ? "" : "s"),
                     line->place,
                     key != "periodic" ? ""
                     : count == 2      ? "1 where the box repeats, 0 where it does not: '# periodic: 1 1'"
                                       : "1 where the box repeats, 0 where it does not: '# periodic: 1 1 0'");
  return found;
}

double LeadingLines::number(std::string_view key, double otherwise) const {
  const auto found = numbers(key, 1);
  return found ? (*found)[0] : otherwise;
}

}  // namespace jam
