#include "jamscape/report/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace jam {
namespace {

void append_word(std::string& bytes, std::uint32_t word, int size) {
  for (int k = 0; k < size; ++k) bytes.push_back(static_cast<char>((word >> (8 * k)) & 0xFFu));
}

}  // namespace

Json rounded(double value, int digits) {
  if (!std::isfinite(value)) return nullptr;
  const double near = std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr);
  // Whole numbers without ".0": shorter, and the same to JavaScript.
  if (std::abs(near) < 1e9 && near == std::floor(near)) return static_cast<std::int64_t>(near);
  return near;
}

Json rounded(const std::vector<double>& values, int digits) {
  Json list = Json::array();
  for (const double value : values) list.push_back(rounded(value, digits));
  return list;
}

std::string base64(std::string_view bytes) {
  static constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const std::size_t have = std::min<std::size_t>(3, bytes.size() - k);
    std::uint32_t group = 0;
    for (std::size_t b = 0; b < 3; ++b)
      group = (group << 8) | (b < have ? static_cast<unsigned char>(bytes[k + b]) : 0u);
    for (std::size_t b = 0; b < 4; ++b) text.push_back(b <= have ? letters[(group >> (18 - 6 * b)) & 63u] : '=');
  }
  return text;
}

std::string packed_words(const std::vector<double>& values, double lo, double hi) {
  std::string bytes;
  bytes.reserve(2 * values.size());
  const double scale = hi > lo ? 65535.0 / (hi - lo) : 0.0;
  for (const double value : values)
    append_word(bytes, static_cast<std::uint32_t>(std::lround(std::clamp((value - lo) * scale, 0.0, 65535.0))), 2);
  return base64(bytes);
}

std::string packed_indices(const std::vector<std::uint32_t>& indices, bool wide) {
  std::string bytes;
  bytes.reserve((wide ? 4 : 2) * indices.size());
  for (const std::uint32_t index : indices) append_word(bytes, index, wide ? 4 : 2);
  return base64(bytes);
}

}  // namespace jam
