// A study as named on the command line.
#pragma once

#include <string>
#include <vector>

#include "jamscape/study/study.hpp"

namespace jam::app {

/// A file, or the name of a built-in study where no such file exists. Throws a usage error.
Study find_study(const std::string& name, const std::vector<std::string>& settings);

}  // namespace jam::app
