// Numbers on their way into the page: short, because nobody reads more digits off a figure. Results keep theirs.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

namespace jam {

using Json = nlohmann::ordered_json;

/// The nearest number of so many significant digits; null for one that is not finite.
Json rounded(double value, int digits = 5);

Json rounded(const std::vector<double>& values, int digits = 5);

/// Text in base64.
std::string base64(std::string_view bytes);

/// Values in [lo, hi] as 16-bit words (0 at lo, 65535 at hi, clipped outside), little-endian, in base64.
std::string packed_words(const std::vector<double>& values, double lo, double hi);

/// Indices as 16-bit words when all are below 65536 (`wide` false), else as 32-bit words; little-endian, in base64.
std::string packed_indices(const std::vector<std::uint32_t>& indices, bool wide);

}  // namespace jam
