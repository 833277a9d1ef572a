// Which of many frames are shown.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace jam {

/// Of frames with their packing fractions: those at multiples of .02 (S1 shows these), the last `most` of them; where
/// fewer than three are, up to `most` evenly spaced in number.
std::vector<std::int64_t> even_frames(const std::map<std::int64_t, double>& rho, std::size_t most);

/// The frame of the largest packing fraction; none of none.
std::vector<std::int64_t> last_frame(const std::map<std::int64_t, double>& rho);

/// For each wanted packing fraction the nearest frame, without repeats.
std::vector<std::int64_t> nearest_frames(const std::map<std::int64_t, double>& rho, const std::vector<double>& wanted);

}  // namespace jam
