// Names that people give to studies, systems and stages; they become parts of keys and file names.
#pragma once

#include <string>
#include <string_view>

namespace jam {

/// Throws a usage error unless the name is made of letters, digits and the characters allowed, and begins with no dot.
void check_name(const std::string& name, std::string_view allowed, const std::string& what, const std::string& place);

}  // namespace jam
