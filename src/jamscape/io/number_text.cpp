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

std::string to_text(double value) {
  char buffer[64];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, end};
}

}  // namespace jam
