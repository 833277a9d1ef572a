// The studies that come with the program (folder studies/), kept inside it.
#pragma once

#include <string_view>
#include <vector>

namespace jam {

struct BuiltinFile {
  std::string_view name;  ///< file name, e.g. "quickstart.toml" or "kramar2013.targets.toml"
  std::string_view text;
};

/// All files of studies/, sorted by name.
const std::vector<BuiltinFile>& builtin_files();

/// Names of the studies, without ".toml"; files of targets are left out.
std::vector<std::string_view> builtin_studies();

/// Text of a file, or an empty view.
std::string_view builtin_file(std::string_view name);

}  // namespace jam
