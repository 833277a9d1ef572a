// Options are declared once, beside the member they set. A struct of options offers
//
//   template <class Visitor> void describe(Visitor& v) {
//     v.option("friction", friction, {.text = "Coulomb friction coefficient", .min = 0});
//     v.group("size", size);                     // a nested struct with its own describe()
//   }
//
// and parser, errors with place and nearest key, `explain`, the generated reference and stored provenance all
// come from that one declaration: each is a Visitor with option(key, member&, meta) and group(key, struct&).
// The default of an option is the value its member has in a default-constructed struct.
#pragma once

#include <limits>
#include <string_view>

namespace jam {

struct OptionMeta {
  std::string_view text;                                  ///< one sentence: what it is
  std::string_view unit = "";                             ///< of a bare number, in scaled units: "d/tau_c" (units.hpp)
  double min = -std::numeric_limits<double>::infinity();  ///< smallest allowed value
  double max = std::numeric_limits<double>::infinity();   ///< largest allowed value
  bool above_min = false;                                 ///< true: min itself is not allowed
  bool si = false;                                        ///< true: `unit` is an SI unit, "Pa"
  std::string_view source = "";                           ///< paper and place, e.g. "S1 App. A"
};

/// Names of an enum's values as they stand in study files; specialise for each enum used as an option:
///   template <> struct EnumNames<Lattice> {
///     static constexpr std::pair<Lattice, std::string_view> values[] = {{Lattice::square, "square"}, ...};
///   };
template <class E>
struct EnumNames;

}  // namespace jam
