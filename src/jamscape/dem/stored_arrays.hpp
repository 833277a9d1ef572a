// Arrays of an engine as a checkpoint holds them, and back.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

#include "jamscape/base/archive.hpp"
#include "jamscape/base/error.hpp"
#include "jamscape/geometry/vec.hpp"

namespace jam {

[[noreturn]] inline void refuse_checkpoint(const std::string& problem) {
  throw data_error("the checkpoint" + problem, {}, "delete it; the task then starts from its beginning");
}

template <class Array>
std::vector<double> reals(const Array& a) {
  return {std::begin(a), std::end(a)};
}
template <class Array>
std::vector<std::int64_t> integers(const Array& a) {
  return {std::begin(a), std::end(a)};
}
template <int D>
std::vector<double> components(const std::vector<Vec<D>>& vectors) {
  std::vector<double> out;
  for (const Vec<D>& v : vectors) out.insert(out.end(), v.c, v.c + D);
  return out;
}

/// The entry of this name. Throws a data error where there is none of its type.
template <class T>
const T& fetch(const Archive& archive, const std::string& name) {
  if (const T* entry = find_entry<T>(archive, name)) return *entry;
  refuse_checkpoint(" lacks '" + name + "'");
}

/// All its numbers into `to`.
template <class Array>
void take(const Archive& archive, const std::string& name, Array& to) {
  using Stored = std::conditional_t<std::is_floating_point_v<typename Array::value_type>, double, std::int64_t>;
  const auto& from = fetch<std::vector<Stored>>(archive, name);
  if constexpr (requires { to.resize(from.size()); }) to.resize(from.size());
  std::transform(from.begin(), from.end(), to.begin(),
                 [](Stored a) { return static_cast<typename Array::value_type>(a); });
}

/// The same; throws a data error for another length than `size`.
template <class Array>
void take(const Archive& archive, const std::string& name, Array& to, std::size_t size) {
  using Stored = std::conditional_t<std::is_floating_point_v<typename Array::value_type>, double, std::int64_t>;
  const std::size_t found = fetch<std::vector<Stored>>(archive, name).size();
  if (found != size)
    refuse_checkpoint(" is of another system: '" + name + "' has " + std::to_string(found) + " entries instead of " +
                      std::to_string(size));
  take(archive, name, to);
}

template <int D>
void take(const Archive& archive, const std::string& name, std::vector<Vec<D>>& to, std::size_t size) {
  std::vector<double> components;
  take(archive, name, components, size * D);
  to.resize(size);
  for (std::size_t k = 0; k < size; ++k) std::copy_n(components.data() + k * D, D, to[k].c);
}

}  // namespace jam
