// Values written as text with a unit, "2.5e-5 d/tau_c". The one place where units are read and, for dimensional
// studies, will be converted.
#pragma once

#include <string>
#include <string_view>

#include "jamscape/base/option.hpp"

namespace jam {

/// The number in the option's own unit. In scaled units (d, m, tau_c) that unit is the only one allowed. Throws a
/// usage error for text that is no number, a missing or unknown unit, or a unit of something else.
double read_quantity(std::string_view text, std::string_view key, const OptionMeta& meta, const std::string& place);

}  // namespace jam
