#include "jamscape/io/number_text.hpp"

#include <algorithm>
#include <charconv>

namespace jam {
namespace {

/// std::from_chars takes no leading +.
std::string_view without_plus(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+') text.remove_prefix(1);
  return text;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::optional<double> parse_double(std::string_view text) {
  text = without_plus(trimmed(text));
  std::string fortran;
  if (const auto at = text.find_first_of("dD"); at != std::string_view::npos) {
    fortran = text;
    fortran[at] = 'e';
    text = fortran;
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || text.empty()) return {};
  if (error == std::errc::result_out_of_range) {
    // Too small is zero, too large is nothing: the exponent's sign tells which.
    const auto exponent = text.find_first_of("eE");
    const bool small =
        exponent != std::string_view::npos ? text.substr(exponent + 1).starts_with('-') : trimmed(text).find('.') <= 2;
    if (!small) return {};
    return text[0] == '-' ? -0.0 : 0.0;
  }
  if (error != std::errc{}) return {};
  return value;
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  text = without_plus(trimmed(text));
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  if (value == 0 && text[0] == '-') return {};
  return value;
}

std::optional<std::int64_t> parse_whole_number(std::string_view text) {
  constexpr std::int64_t most_zeros = 5;  // what an exponent may append; more is how spreadsheets round
  text = without_plus(trimmed(text));
  const auto mark = std::min(text.size(), text.find_first_of("eEdD"));
  std::int64_t exponent = 0;
  if (mark < text.size()) {
    const auto parsed = parse_integer(text.substr(mark + 1) == "-0" ? "0" : text.substr(mark + 1));
    if (!parsed || *parsed < -400 || *parsed > 400) return {};
    exponent = *parsed;
  }
  const std::string_view mantissa = text.substr(0, mark);
  const auto point = std::min(mantissa.size(), mantissa.find('.'));
  std::string digits(mantissa.substr(0, point));
  std::string fraction(point < mantissa.size() ? mantissa.substr(point + 1) : std::string_view{});
  if (digits.empty() || digits == "-" || fraction.find_first_not_of("0123456789") != std::string::npos) return {};
  for (; exponent < 0 && digits.size() > (digits[0] == '-' ? 2u : 1u); ++exponent) {
    fraction.insert(fraction.begin(), digits.back());
    digits.pop_back();
  }
  if (exponent < 0) return {};
  const auto given = static_cast<std::int64_t>(fraction.size());
  if (exponent > given + most_zeros) return {};
  fraction.resize(static_cast<std::size_t>(std::max(given, exponent)), '0');
  digits += fraction.substr(0, static_cast<std::size_t>(exponent));
  if (fraction.find_first_not_of('0', static_cast<std::size_t>(exponent)) != std::string::npos) return {};
  return parse_integer(digits);
}

std::string to_text(double value) {
  char buffer[64];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, end};
}

}  // namespace jam
