#include "jamscape/base/units.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "jamscape/base/error.hpp"
#include "jamscape/base/nearest.hpp"

namespace jam {
namespace {

using NamedUnit = std::pair<std::string_view, Unit>;

constexpr NamedUnit scaled_names[] = {{"d", {{1, 0, 0}}}, {"m", {{0, 1, 0}}}, {"tau_c", {{0, 0, 1}}}};

constexpr Dimensions force{1, 1, -2}, pressure{-1, 1, -2}, energy{2, 1, -2};
constexpr NamedUnit si_names[] = {{"m", {{1, 0, 0}}},
                                  {"km", {{1, 0, 0}, 1e3}},
                                  {"cm", {{1, 0, 0}, 1, 1e2}},
                                  {"mm", {{1, 0, 0}, 1, 1e3}},
                                  {"um", {{1, 0, 0}, 1, 1e6}},
                                  {"kg", {{0, 1, 0}}},
                                  {"g", {{0, 1, 0}, 1, 1e3}},
                                  {"mg", {{0, 1, 0}, 1, 1e6}},
                                  {"s", {{0, 0, 1}}},
                                  {"ms", {{0, 0, 1}, 1, 1e3}},
                                  {"us", {{0, 0, 1}, 1, 1e6}},
                                  {"min", {{0, 0, 1}, 60}},
                                  {"h", {{0, 0, 1}, 3600}},
                                  {"Hz", {{0, 0, -1}}},
                                  {"rad", {}},
                                  {"N", {force}},
                                  {"mN", {force, 1, 1e3}},
                                  {"uN", {force, 1, 1e6}},
                                  {"kN", {force, 1e3}},
                                  {"Pa", {pressure}},
                                  {"kPa", {pressure, 1e3}},
                                  {"MPa", {pressure, 1e6}},
                                  {"GPa", {pressure, 1e9}},
                                  {"J", {energy}},
                                  {"mJ", {energy, 1, 1e3}},
                                  {"uJ", {energy, 1, 1e6}}};

/// unit = factor {("*" | " " | "/") factor},  factor = (name | "1" | "(" unit ")") ["^" number]; "/" holds for the
/// factor behind it.
class UnitReader {
 public:
  UnitReader(std::string_view text, const NamedUnit* begin, const NamedUnit* end)
      : text_(text), begin_(begin), end_(end) {}

  std::optional<Unit> read() {
    Unit unit;
    if (!product(unit)) return std::nullopt;
    return at_ == text_.size() ? std::optional(unit) : std::nullopt;
  }

 private:
  static void multiply(Unit& a, Unit b, double power) {
    if (power < 0) std::swap(b.over, b.under);
    const auto raised = [power](double x) { return x == 1 ? 1 : std::pow(x, std::abs(power)); };
    a.over *= raised(b.over), a.under *= raised(b.under);
    a.dimensions.length += power * b.dimensions.length;
    a.dimensions.mass += power * b.dimensions.mass;
    a.dimensions.time += power * b.dimensions.time;
  }

  void skip_blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  bool take(char c) {
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  bool product(Unit& unit) {
    double sign = 1;
    for (skip_blanks(); at_ < text_.size() && text_[at_] != ')'; skip_blanks()) {
      if (!factor(unit, sign)) return false;
      sign = take('/') ? -1 : 1;
      if (sign > 0) take('*');
    }
    return sign > 0;
  }

  bool factor(Unit& unit, double sign) {
    skip_blanks();
    Unit one;
    if (take('(')) {
      if (!product(one) || !take(')')) return false;
    } else if (!take('1')) {
      const std::size_t first = at_;
      const auto part = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
      while (at_ < text_.size() && part(text_[at_])) ++at_;
      const std::string_view name = text_.substr(first, at_ - first);
      const NamedUnit* known = begin_;
      while (known != end_ && known->first != name) ++known;
      if (known == end_) return false;
      one = known->second;
    }
    double power = 1;
    if (take('^')) {
      const auto [next, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), power);
      if (error != std::errc{} || !(std::abs(power) < 10)) return false;
      at_ = static_cast<std::size_t>(next - text_.data());
    }
    multiply(unit, one, sign * power);
    return true;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  const NamedUnit *begin_, *end_;
};

std::string names_with_powers(const std::vector<std::pair<const char*, double>>& factors) {
  std::string text;
  for (const auto& [name, power] : factors)
    text += fmt::format("{}{}{}", text.empty() ? "" : " ", name, power == 1 ? "" : fmt::format("^{}", power));
  return text;
}

[[noreturn]] void refuse(const std::string& unit, const std::string& number, std::string_view key,
                         const OptionMeta& meta, const std::optional<Dimensions>& wanted, const std::string& place,
                         const Scales& scales) {
  const bool convertible = wanted && (meta.si || scales.known());
  std::string problem, advice;
  if (const std::optional<Unit> si = read_si_unit(unit); !si) {
    std::vector<std::string> known;
    for (const NamedUnit& u : si_names) known.emplace_back(u.first);
    problem = "that is no unit of this option";
    if (const std::string near = convertible ? nearest(unit, known) : ""; !near.empty())
      advice = fmt::format("did you mean '{}'? ", near);
  } else if (!convertible) {
    problem = "this study is in scaled units";
    if (wanted && same(si->dimensions, *wanted)) advice = "tell d, m and tau_c in a [units] group, or ";
  } else {
    problem = fmt::format("that is a unit of {}", si_unit(si->dimensions));
  }
  advice += fmt::format("give it in {}, as a bare number or as \"{} {}\"", meta.unit, number, meta.unit);
  if (convertible) advice += fmt::format(", or in an SI unit such as {}", si_unit(*wanted));
  throw usage_error(fmt::format("'{}' cannot be in '{}': {}", key, unit, problem), place, advice);
}

}  // namespace

bool same(const Dimensions& a, const Dimensions& b) {
  return std::abs(a.length - b.length) < 1e-9 && std::abs(a.mass - b.mass) < 1e-9 && std::abs(a.time - b.time) < 1e-9;
}

std::optional<Dimensions> read_scaled_unit(std::string_view text) {
  const std::optional<Unit> unit = UnitReader(text, std::begin(scaled_names), std::end(scaled_names)).read();
  return unit ? std::optional(unit->dimensions) : std::nullopt;
}

std::optional<Unit> read_si_unit(std::string_view text) {
  return UnitReader(text, std::begin(si_names), std::end(si_names)).read();
}

std::string si_unit(const Dimensions& d) {
  std::vector<std::pair<const char*, double>> over, under;
  for (const auto& [name, power] : {std::pair("kg", d.mass), std::pair("m", d.length), std::pair("s", d.time)}) {
    if (power > 0) over.emplace_back(name, power);
    if (power < 0) under.emplace_back(name, -power);
  }
  if (over.empty() && under.empty()) return "a bare number";
  std::string text = over.empty() ? "1" : names_with_powers(over);
  if (under.size() == 1) text += fmt::format("/{}", names_with_powers(under));
  if (under.size() > 1) text += fmt::format("/({})", names_with_powers(under));
  return text;
}

double Scales::of(const Dimensions& d) const {
  return std::pow(length, d.length) * std::pow(mass, d.mass) * std::pow(time, d.time);
}

double to_scaled(double value, const Dimensions& dimensions, const Scales& scales) {
  return std::strtod(fmt::format("{:.12g}", value / scales.of(dimensions)).c_str(), nullptr);
}

double read_quantity(std::string_view text, std::string_view key, const OptionMeta& meta, const std::string& place,
                     const Scales& scales) {
  const std::size_t first = text.find_first_not_of(" \t");
  const std::string_view trimmed = first == std::string_view::npos ? "" : text.substr(first);
  double value = 0;
  const auto [end, error] = std::from_chars(trimmed.data(), trimmed.data() + trimmed.size(), value);
  if (error != std::errc{})
    throw usage_error(fmt::format("'{}' is the text \"{}\", where a number is expected", key, text), place,
                      fmt::format("jamscape explain {}", key));
  const std::string number(trimmed.data(), end);
  std::string unit(end, trimmed.data() + trimmed.size());
  while (!unit.empty() && (unit.back() == ' ' || unit.back() == '\t')) unit.pop_back();
  unit.erase(0, std::min(unit.find_first_not_of(" \t"), unit.size()));

  if (unit.empty())
    throw usage_error(fmt::format("'{}' is the text \"{}\" without a unit", key, text), place,
                      fmt::format("write the bare number {}", number));
  if (meta.unit.empty())
    throw usage_error(fmt::format("'{}' has no unit, but \"{}\" gives it one", key, text), place,
                      fmt::format("write the bare number {}", number));
  std::optional<Dimensions> wanted;
  if (!meta.si) {
    wanted = read_scaled_unit(meta.unit);
    const std::optional<Dimensions> scaled = read_scaled_unit(unit);
    if (unit == meta.unit || (scaled && wanted && same(*scaled, *wanted))) return value;
  } else if (const std::optional<Unit> own = read_si_unit(meta.unit)) {
    wanted = own->dimensions;
  }
  const std::optional<Unit> si = read_si_unit(unit);
  if (!si || !wanted || !same(si->dimensions, *wanted) || !(meta.si || scales.known()))
    refuse(unit, number, key, meta, wanted, place, scales);
  const double in_si = value * si->over / si->under;
  return meta.si ? in_si : to_scaled(in_si, *wanted, scales);
}

}  // namespace jam
