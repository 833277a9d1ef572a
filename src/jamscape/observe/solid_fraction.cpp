#include "jamscape/observe/solid_fraction.hpp"

#include <algorithm>

#include "jamscape/observe/bodies.hpp"
#include "jamscape/observe/box.hpp"
#include "jamscape/observe/entry.hpp"
#include "jamscape/observe/ratio.hpp"
#include "jamscape/stats/none.hpp"

namespace jam {
namespace {

template <class Value>
double sum_over(std::size_t count, const Value& value) {
  double sum = 0;
  for (std::size_t k = 0; k < count; ++k) sum += value(k);
  return sum;
}

// Of a layer of clusters: the diameter of their thickest arm at size factor 1.
double thickness(const Packing& p) {
  if (p.dimension == 3 || p.shapes.empty()) return 1;
  double radius = 0;
  for (const ClusterShape& shape : p.shapes)
    for (const Arm& arm : shape.arms) radius = std::max(radius, arm.radius);
  return 2 * radius;
}

}  // namespace

double solid_fraction(const Packing& p) {
  return ratio(sum_over(p.grains.size(), [&](std::size_t i) { return body_volume(p, i); }),
               box_volume(p) * thickness(p));
}

double weight_over_load(const Packing& p) {
  const Wall* lid = find_lid(p);
  if (lid == nullptr) return none;
  const double load = -dot(lid->force, lid->normal);
  const double weight = sum_over(p.walls.size(), [&](std::size_t w) { return dot(p.walls[w].force, lid->normal); });
  return load > 0 ? weight / load : none;
}

Measure solid_fraction_measure() {
  return frame_measure(
      {"solid_fraction", "solid fraction and load",
       "solid_fraction = sum V/(volume of the space up to the lid, V of the measure stress), V the union of a "
       "cluster's arms; in two dimensions of clusters the space is as thick as an arm, of discs areas are taken. "
       "weight_over_load = (weight of the "
       "grains)/(force on the lid): what S3's 500 N leave of the gradient of gravity. The weight is what all walls "
       "carry, which is right while the grains rest. The lid is the wall of that role (where roles are not given, the "
       "last one "
       "that is no cylinder); without one, or where it carries nothing, weight_over_load is missing.",
       "S3, Data analysis and Suppl.; theory sec. 4, 5"},
      {{"solid_fraction", "", "volume of the grains over that of the space; overlaps count twice"},
       {"area_fraction", "", "area of the grains over that of the space; 0 in three dimensions"},
       {"height", "d", "distance of the lid from the floor"},
       {"weight_over_load", "", "weight of the grains over the force on the lid; missing without a lid that carries"},
       {"deepest_overlap", "d", "largest overlap of all contacts, walls among them; 0 without contacts"}},
      [](const Snapshot& s) {
        const Packing& p = s.packing();
        double area = 0, deepest = 0;
        if (p.dimension == 2) area = sum_over(p.grains.size(), [&](std::size_t i) { return body_area(p, i); });
        for (const double overlap : p.contacts.overlap) deepest = std::max(deepest, overlap);
        const int axis = height_axis(p);
        return std::vector<double>{solid_fraction(p), ratio(area, box_volume(p)), box_sides(p)[axis],
                                   weight_over_load(p), deepest};
      });
}

}  // namespace jam
