#include "jamscape/study/names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "jamscape/base/error.hpp"

namespace jam {

void check_name(const std::string& name, std::string_view allowed, const std::string& what, const std::string& place) {
  const auto good = [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           allowed.find(c) != std::string_view::npos;
  };
  if (!name.empty() && name.front() != '.' && std::all_of(name.begin(), name.end(), good)) return;
  throw usage_error(fmt::format("'{}' cannot be the name of a {}", name, what), place,
                    fmt::format("use letters, digits and {}", allowed));
}

}  // namespace jam
