// Words to people on standard error, which may be gone.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <utility>

namespace jam::app {

/// Unlike fmt::print it does not throw where nobody reads: no result may depend on that.
template <class... Arguments>
void complain(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  std::fputs(fmt::format(format, std::forward<Arguments>(arguments)...).c_str(), stderr);
}

}  // namespace jam::app
