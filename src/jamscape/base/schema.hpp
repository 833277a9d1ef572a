// Options as data: a flat list of keys, each bound to the member it sets, taken from the describe() of a struct of
// options (see option.hpp). Parsing, printing, hashing and explaining work on that list.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "jamscape/base/option.hpp"
#include "jamscape/base/units.hpp"

namespace jam {

/// An enum member seen through the names of its values.
struct EnumTarget {
  std::vector<std::string_view> names;
  std::function<std::size_t()> get;
  std::function<void(std::size_t)> set;
};

using OptionTarget = std::variant<bool*, std::int64_t*, double*, std::string*, std::vector<double>*,
                                  std::vector<std::string>*, EnumTarget>;

/// One option of a struct that outlives it.
struct Option {
  std::string key;  ///< dotted path as in study files, e.g. "grains.width"
  OptionMeta meta;
  OptionTarget target;
};

/// A value as it was written, before it is known which option it is for.
struct Written {
  std::variant<bool, std::int64_t, double, std::string, std::vector<Written>> value;
  std::string place;  ///< file:line:column
};

namespace detail {

struct ListOptions {
  std::vector<Option>& list;
  std::string prefix;

  template <class T>
  void option(std::string_view key, T& member, const OptionMeta& meta) {
    OptionTarget target;
    if constexpr (std::is_enum_v<T>) {
      EnumTarget e;
      for (const auto& [value, name] : EnumNames<T>::values) e.names.push_back(name);
      e.get = [&member] {
        std::size_t k = 0;
        while (EnumNames<T>::values[k].first != member) ++k;
        return k;
      };
      e.set = [&member](std::size_t k) { member = EnumNames<T>::values[k].first; };
      target = std::move(e);
    } else {
      target = &member;
    }
    list.push_back({prefix + std::string(key), meta, std::move(target)});
  }

  template <class S>
  void group(std::string_view key, S& member) {
    ListOptions inner{list, prefix + std::string(key) + "."};
    member.describe(inner);
  }
};

}  // namespace detail

/// The options of a struct, in the order of its describe(); keys start with `prefix` (which ends in '.' or is empty).
template <class S>
std::vector<Option> options_of(S& s, std::string prefix = {}) {
  std::vector<Option> list;
  detail::ListOptions visitor{list, std::move(prefix)};
  s.describe(visitor);
  return list;
}

/// Sets the option; throws a usage error (place, reason, what is allowed) for a wrong type, unit, name or range.
/// Numbers written as text with an SI unit are converted with `scales`.
void assign(const Option& option, const Written& written, const Scales& scales = {});

/// The present value as TOML; numbers in their shortest form that reads back to the same bits.
std::string print_value(const Option& option);

/// What may stand there, for people: "number", "integer", "one of square, hexagonal", ...
std::string describe_type(const Option& option);

/// The allowed range for people, e.g. "> 0, at most 0.2"; empty where everything is allowed.
std::string describe_range(const OptionMeta& meta);

/// Shortest decimal text that reads back to the same double, always recognisable as a float ("1.0", "2.5e-05").
std::string print_number(double value);

/// A TOML basic string.
std::string print_text(std::string_view text);

/// Throws a usage error for a key no option has, naming the nearest.
[[noreturn]] void throw_unknown_key(std::string_view key, const std::vector<std::string>& known, std::string place);

}  // namespace jam
