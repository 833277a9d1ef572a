#include "jamscape/base/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

std::string without_blanks(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (c != ' ' && c != '\t') out += c;
  return out;
}

constexpr std::array<std::string_view, 26> si_units = {
    "m",   "cm",  "mm",  "um",  "s",    "ms",   "us",    "kg",  "g",       "mg",     "N",      "mN", "Pa",
    "kPa", "MPa", "GPa", "m/s", "cm/s", "mm/s", "m/s^2", "N/m", "N/m^1.5", "kg/m^3", "g/cm^3", "Hz", "rad/s"};

}  // namespace

double read_quantity(std::string_view text, std::string_view key, const OptionMeta& meta, const std::string& place) {
  const std::size_t first = text.find_first_not_of(" \t");
  const std::string_view trimmed = first == std::string_view::npos ? "" : text.substr(first);
  double value = 0;
  const auto [end, error] = std::from_chars(trimmed.data(), trimmed.data() + trimmed.size(), value);
  if (error != std::errc{})
    throw usage_error(fmt::format("'{}' is the text \"{}\", where a number is expected", key, text), place,
                      fmt::format("jamscape explain {}", key));
  const std::string unit = without_blanks({end, static_cast<std::size_t>(trimmed.data() + trimmed.size() - end)});
  if (unit == without_blanks(meta.unit) && !unit.empty()) return value;

  const std::string number(trimmed.data(), end);
  if (unit.empty())
    throw usage_error(fmt::format("'{}' is the text \"{}\" without a unit", key, text), place,
                      fmt::format("write the bare number {}", number));
  if (meta.unit.empty())
    throw usage_error(fmt::format("'{}' has no unit, but \"{}\" gives it one", key, text), place,
                      fmt::format("write the bare number {}", number));
  const bool si = std::find(si_units.begin(), si_units.end(), unit) != si_units.end();
  throw usage_error(fmt::format("'{}' cannot be in '{}': {}", key, unit,
                                si ? "this study is in scaled units" : "that is no unit of this option"),
                    place,
                    fmt::format("give it in {}, as a bare number or as \"{} {}\"", meta.unit, number, meta.unit));
}

}  // namespace jam
