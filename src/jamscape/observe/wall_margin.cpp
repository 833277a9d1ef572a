#include "jamscape/observe/wall_margin.hpp"

#include <algorithm>

#include "jamscape/base/mean.hpp"

namespace jam {

Room room_with_margin(const Packing& p, double margin, double layer) {
  Room r(p, layer);
  for (int a = 0; a < p.dimension; ++a)
    if (r.walled(a)) r.margin[a] = std::min(margin, r.width(a) / 6);
  r.round_margin = std::min(margin, r.diameter() / 6);
  return r;
}

WallMargin::WallMargin(const Packing& packing, const MeasureOptions& options) {
  if (options.force_margin > 0)
    room_ = room_with_margin(packing, options.force_margin * 2 * mean_of(packing.grains.radius), 0);
}

}  // namespace jam
