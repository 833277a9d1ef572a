// What a study file says of one system, and the system made of it. Keys may come in any order and from several places
// (study, [[system]], sweep, command line), and what a value means may hang on another: SI units are converted with
// the system's own collision time. So everything is gathered first, and assigned in one go.
#pragma once

#include <string>
#include <vector>

#include "jamscape/study/study.hpp"
#include "jamscape/study/toml_leaves.hpp"

namespace jam {

struct SystemText {
  std::string name;
  std::vector<std::string> stages;  ///< their names, in order
  std::vector<Leaf> leaves;         ///< keys as in system_keys(); of two with the same key the later counts
};

/// Reads [[stage]] tables into `text`, in place of the stages it had.
void read_stages(const toml::node& node, const std::string& key, const std::string& file, SystemText& text);

/// Throws a usage error with the place of the leaf that is wrong.
System make_system(const SystemText& text);

}  // namespace jam
