// What can be said of a study before it is run: where it will not do quite what was asked for, with the number that
// would.
#pragma once

#include <string>
#include <vector>

#include "jamscape/study/study.hpp"
#include "jamscape/study/task.hpp"

namespace jam {

/// One sentence each, for people; empty where there is nothing to say.
std::vector<std::string> advice(const Study& study, const std::vector<Task>& tasks);

}  // namespace jam
