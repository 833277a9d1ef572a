// Numbers as text, the same in every locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace jam {

/// The text without blanks and tabs at its ends.
std::string_view trimmed(std::string_view text);

/// The whole text as a number: decimal, with e, E, d or D exponents, a leading + allowed, nan and inf in any case. No
/// value when it is anything else, or too large for a double.
std::optional<double> parse_double(std::string_view text);

/// The whole text as an integer in range; "-0" is none, since it would lose its sign.
std::optional<std::int64_t> parse_integer(std::string_view text);

/// The whole text as an integer in range that is written with a point or an exponent and shows all its digits: 3.0,
/// 1.2e1, 1e3; not 1.5, nor 7.2e16, which stands for any of 10^15 numbers.
std::optional<std::int64_t> parse_whole_number(std::string_view text);

/// The shortest text that reads back as the same number.
std::string to_text(double value);

}  // namespace jam
