#include "jamscape/study/builtin.hpp"

namespace jam {

std::vector<std::string_view> builtin_studies() {
  std::vector<std::string_view> names;
  for (const BuiltinFile& file : builtin_files())
    if (!file.name.ends_with(".targets.toml")) names.push_back(file.name.substr(0, file.name.size() - 5));
  return names;
}

std::string_view builtin_file(std::string_view name) {
  for (const BuiltinFile& file : builtin_files())
    if (file.name == name) return file.text;
  return {};
}

}  // namespace jam
