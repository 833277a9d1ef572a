// How a packing becomes a network and numbers: options of the measures. They never influence a simulation.
#pragma once

#include <utility>

#include "jamscape/base/option.hpp"

namespace jam {

/// Which force of a contact is the weight of its edge.
enum class EdgeForce { normal, total };
template <>
struct EnumNames<EdgeForce> {
  static constexpr std::pair<EdgeForce, std::string_view> values[] = {{EdgeForce::normal, "normal"},
                                                                      {EdgeForce::total, "total"}};
};

struct MeasureOptions {
  EdgeForce force = EdgeForce::normal;
  double clamp = 5;               // in mean forces; 0: none
  bool remove_rattlers = false;   // S2: once, not recursively

  template <class V>
  void describe(V& v) {
    v.option("force", force, {.text = "weight of an edge: normal force (S1) or total contact force (S2)"});
    v.option("clamp", clamp, {.text = "largest weight kept, in mean forces; 0 keeps all", .min = 0, .max = 1e9,
                              .source = "S1 Sec. II.C"});
    v.option("remove_rattlers", remove_rattlers,
             {.text = "remove grains with fewer than two contacts, once", .source = "S2 Sec. 4"});
  }
};

}  // namespace jam
