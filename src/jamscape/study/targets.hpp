// Published values as data (studies/*.targets.toml). Each [[target]] is a value with a tolerance,
//
//   quantity = "rho_c", value = 0.814, tolerance = 0.004, where = { contact.friction = 0, grains.width = 0.4 }
//
// or an order: left greater than right by more than two standard errors,
//
//   left  = { quantity = "b0_strong", at = "max", where = { ... } }
//   right = { quantity = "b0_strong", at = "max", where = { ... } }      or     right = { value = 0.8 }
//
// or, with a tolerance beside the two sides, their agreement. `where` picks the systems by their options; a target
// whose `where` fits several systems is scored for each, both sides in the same one if `right` has no `where`.
//
// A side is a transition (transitions.hpp), or is read off the curve of each realisation over the packing fraction:
//
//   quantity  column of frames.csv, or measure.column: there the rows of a state become one number by `reduce`, over
//             those whose first abscissa lies in `over`
//   at        which state of that curve: "0.9", "first", "last", "rho_c", "rho_j-0.04", ... (the nearest, at most
//             one state beyond the ends), or what the curve makes of all states, or of those in `between`: "max",
//             "min", "mean"
//   minus     a state whose value is taken off
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

enum class Reduce { mean, max, min, sd, argmax, width };
template <>
struct EnumNames<Reduce> {
  static constexpr std::pair<Reduce, std::string_view> values[] = {
      {Reduce::mean, "mean"}, {Reduce::max, "max"},       {Reduce::min, "min"},
      {Reduce::sd, "sd"},     {Reduce::argmax, "argmax"}, {Reduce::width, "width"}};
};

/// A state, or several, on the axis of packing fraction.
struct StateName {
  enum class Kind { near, first, last, max, min, mean };
  Kind kind = Kind::near;
  std::string transition;  ///< Kind::near: a transition, or "" for ...
  double offset = 0;       ///< ... the packing fraction itself; else what is added to the transition
};

/// Throws a usage error.
StateName read_state(std::string_view text, const std::string& place);

/// A number taken from each realisation of a system.
struct Side {
  std::string quantity;
  std::string at, minus;
  std::vector<std::string> between;
  bool per_grain = false;
  std::vector<double> over;
  Reduce reduce = Reduce::mean;
  double value = std::numeric_limits<double>::quiet_NaN();  ///< a constant, if there is no quantity
  std::vector<std::pair<std::string, Written>> where;

  template <class V>
  void describe(V& v) {
    v.option("quantity", quantity, {.text = "a transition (rho_c), a column of frames.csv, or measure.column"});
    v.option("at", at, {.text = "state: a packing fraction, first, last, rho_c, rho_j+0.02, or max, min, mean of all"});
    v.option("between", between, {.text = "first and last state of max, min, mean"});
    v.option("minus", minus, {.text = "state whose value is taken off"});
    v.option("per_grain", per_grain, {.text = "divide by the number of grains"});
    v.option("over", over, {.text = "first and last abscissa of measure.column"});
    v.option("reduce", reduce,
             {.text = "rows of a state as one number: mean, max, min, sd of their values; argmax: the abscissa of the "
                      "largest; width: standard deviation of the abscissa, weighted with the values"});
    v.option("value", value, {.text = "a constant instead of a quantity"});
  }
};

struct Target {
  std::string name, source, known_deviation;
  std::int64_t realisations = 1;
  double tolerance = -1;  ///< negative: an order
  Side left, right;       ///< of a value: left is the quantity, right the published constant

  bool is_order() const { return tolerance < 0; }
  bool is_value() const { return !is_order() && right.quantity.empty(); }
};

/// Throws a usage error with file:line:column.
std::vector<Target> read_targets(std::string_view text, const std::string& file);

}  // namespace jam
