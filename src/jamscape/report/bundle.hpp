// The page's program and style (web/dist), kept inside the program.
#pragma once

#include <string>

namespace jam {

std::string bundle_script();
std::string bundle_style();

}  // namespace jam
