// A bag of named arrays: how a simulation hands its complete state to a file and takes it back, bit for bit,
// without the file layer knowing what the arrays mean.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace jam {

using ArchiveValue = std::variant<std::vector<double>, std::vector<std::int64_t>, std::string>;

/// Names may hold '/' to form groups. Doubles keep their exact bits (NaN payloads included).
using Archive = std::map<std::string, ArchiveValue>;

/// The entry of this name and type, or nullptr.
template <class T>
const T* find_entry(const Archive& archive, const std::string& name) {
  const auto at = archive.find(name);
  return at == archive.end() ? nullptr : std::get_if<T>(&at->second);
}

}  // namespace jam
