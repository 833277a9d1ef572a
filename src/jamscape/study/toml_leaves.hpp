// A TOML document as a list of leaves: dotted key, value, place. The only files that know TOML as input are this one,
// study_reader and targets.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

#include "jamscape/base/schema.hpp"

namespace jam {

struct Leaf {
  std::string key;
  Written value;
  toml::source_position at;
  std::string place;  ///< of the key, as file:line:column
};

/// Throws a usage error with the place for text that is no TOML, keys given twice among it.
toml::table parse_toml(std::string_view text, const std::string& file);

std::string place_of(const std::string& file, toml::source_position at);

/// Throws a usage error for a date or a table.
Written written(const toml::node& node, const std::string& file);

/// Leaves in the order in which they were written; `prefix` goes in front of every key, `skip` is left out. (A copy of
/// a toml::table knows no places, so tables are read where they are.)
std::vector<Leaf> leaves_of(const toml::table& table, const std::string& prefix, const std::string& file,
                            std::string_view skip = {});

/// The option a leaf is for; throws a usage error naming the nearest key.
const Option& find_option(const std::vector<Option>& options, const Leaf& leaf);

/// A list of tables; throws a usage error for anything else.
const toml::array& tables_of(const toml::node& node, const std::string& name, const std::string& file);

}  // namespace jam
