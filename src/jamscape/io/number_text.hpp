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

/// The shortest text that reads back as the same number.
std::string to_text(double value);

}  // namespace jam
