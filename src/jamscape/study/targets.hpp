// Published values as data (studies/*.targets.toml). Each [[target]] is either a value with a tolerance,
//
//   quantity = "rho_c", value = 0.814, tolerance = 0.004, where = { contact.friction = 0, grains.width = 0.4 }
//
// or an order: left greater than right by more than two standard errors,
//
//   left  = { quantity = "b0_strong", at = "max", where = { ... } }
//   right = { quantity = "b0_strong", at = "max", where = { ... } }      or     right = { value = 0.8 }
//
// `where` picks the systems by their options; a target whose `where` fits several systems is scored for each, both
// sides in the same one if `right` has no `where`. See Side for the quantities.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "jamscape/base/option.hpp"
#include "jamscape/base/schema.hpp"

namespace jam {

/// A number taken from each realisation of a system.
struct Side {
  std::string quantity;         ///< a transition, a column of `frames`, or "measure.column"
  std::string at;               ///< "0.9", "max", "min", "rho_c", "rho_c+0.02", ...
  bool per_grain = false;       ///< divided by the number of grains
  std::vector<double> over;     ///< range of the first abscissa of "measure.column"
  std::string reduce = "mean";  ///< how the rows in that range become one number: mean, max, sd
  double value = std::numeric_limits<double>::quiet_NaN();  ///< a constant, if there is no quantity
  std::vector<std::pair<std::string, Written>> where;

  template <class V>
  void describe(V& v) {
    v.option("quantity", quantity, {.text = "a transition (rho_c), a column of frames.csv, or measure.column"});
    v.option("at", at, {.text = "packing fraction: a number, max, min, rho_c, or rho_c+0.02"});
    v.option("per_grain", per_grain, {.text = "divide by the number of grains"});
    v.option("over", over, {.text = "first and last abscissa of measure.column"});
    v.option("reduce", reduce, {.text = "mean, max or sd over that range"});
    v.option("value", value, {.text = "a constant instead of a quantity"});
  }
};

struct Target {
  std::string name, source, known_deviation;
  std::int64_t realisations = 1;
  double tolerance = -1;  ///< negative: an order, not a value
  Side left, right;       ///< of a value: left is the quantity, right the published constant

  bool is_value() const { return tolerance >= 0; }
};

/// Throws a usage error with file:line:column.
std::vector<Target> read_targets(std::string_view text, const std::string& file);

}  // namespace jam
