#include "jamscape/dem/pair_list.hpp"

#include <algorithm>
#include <numeric>

#include "jamscape/dem/kept_springs.hpp"
#include "jamscape/dem/pair_search.hpp"

namespace jam {
namespace {

/// Where the grains were when their ids stood as in `old_id`.
std::vector<std::uint32_t> places_then(const std::vector<std::uint32_t>& id, const std::vector<std::uint32_t>& old_id) {
  std::vector<std::uint32_t> place(id.size()), was(id.size());
  for (std::size_t k = 0; k < old_id.size(); ++k) place[old_id[k]] = static_cast<std::uint32_t>(k);
  for (std::size_t k = 0; k < id.size(); ++k) was[k] = place[id[k]];
  return was;
}

/// A pair found.
struct Near {
  std::uint32_t i, j, shift;
  bool touching;
};

/// The pairs of a stretch within its part, or of a part with one other, by kind, i not descending.
struct Shared {
  std::uint32_t with;
  std::array<std::vector<Near>, pair_kinds> found{};
};

/// Writes the touching or the near ones of `found` to the list from `at` on, tile by tile. Returns where they end.
template <int D>
std::size_t put(PairList<D>& list, std::size_t at, const std::vector<Near>& found, bool touching,
                std::size_t tile_size) {
  std::array<std::size_t, Parts::widest_tile> next, end;
  for (std::size_t from = 0; from < found.size();) {
    const std::size_t tile = found[from].i / tile_size;
    std::size_t grains = 0, q = from;
    for (; q < found.size() && found[q].i / tile_size == tile; ++q) {
      if (q == from || found[q].i != found[q - 1].i) next[grains++] = q;
      end[grains - 1] = q + 1;
    }
    from = q;
    for (bool more = true; more;) {
      more = false;
      for (std::size_t g = 0; g < grains; ++g) {
        while (next[g] < end[g] && found[next[g]].touching != touching) ++next[g];
        if (next[g] == end[g]) continue;
        more = true;
        const Near& f = found[next[g]++];
        list.i[at] = f.i, list.j[at] = f.j, list.shift[at] = f.shift;
        ++at;
      }
    }
  }
  return at;
}

/// What has been found by one part.
struct OfPart {
  std::vector<Shared> own;     ///< by stretch
  std::vector<Shared> across;  ///< with others of higher index, in the order found
};

/// Looks for the pairs of a part.
template <int D>
OfPart share(const Bodies<D>& bodies, PairSearch<D> search, const Parts& parts, std::size_t part) {
  OfPart of;
  const auto across_to = [&](std::uint32_t other) -> Shared& {
    for (Shared& s : of.across)
      if (s.with == other) return s;
    return of.across.emplace_back(Shared{other});
  };
  for (auto [stretch, last] = parts.stretches_of(part); stretch < last; ++stretch) {
    Shared& own = of.own.emplace_back(Shared{static_cast<std::uint32_t>(part)});
    const auto [begin, end] = parts.stretch(stretch);
    own.found[0].reserve((end - begin) * (D == 2 ? 4 : 9));
    for (std::size_t k = begin; k < end; ++k) {
      const auto a = static_cast<std::uint32_t>(k);
      for (std::size_t n = search(bodies.row(k), a), q = 0; q < n; ++q) {
        const FoundBody f = search[q];
        const bool across = f.shift != no_shift<D>;
        const PairKind kind = f.j >= bodies.grains ? PairKind::bead : across ? PairKind::across : PairKind::inner;
        const std::uint32_t other = parts.of(f.j);
        Shared& to = other == part ? own : across_to(other);
        to.found[static_cast<std::size_t>(kind)].push_back({a, f.j, f.shift, f.touching});
      }
    }
  }
  return of;
}

/// Lays out the groups of a list, and says for each which pairs found belong to it.
template <int D>
std::vector<const Shared*> lay_out(PairList<D>& list, const std::vector<OfPart>& found, const Parts& parts) {
  std::vector<Neighbours> neighbours;
  std::vector<const Shared*> across;
  for (std::uint32_t a = 0; a < found.size(); ++a)
    for (const Shared& s : found[a].across) {
      neighbours.push_back({a, s.with, s.found[0].size() + s.found[1].size() + s.found[2].size()});
      across.push_back(&s);
    }
  const std::vector<std::uint32_t> round = deal_rounds(neighbours, parts.size());
  std::vector<std::size_t> by_round(across.size());
  std::iota(by_round.begin(), by_round.end(), std::size_t{0});
  std::stable_sort(by_round.begin(), by_round.end(), [&](std::size_t p, std::size_t q) { return round[p] < round[q]; });

  std::vector<const Shared*> order;
  std::size_t at = 0;
  const auto add = [&](std::uint32_t a, const Shared& shared) {
    PairGroup group{a, shared.with, {at}};
    for (std::size_t kind = 0; kind < pair_kinds; ++kind) {
      const auto& pairs = shared.found[kind];
      const auto touching =
          static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), [](const Near& f) { return f.touching; }));
      const auto in_blocks = [](std::size_t n) { return (n + block - 1) / block * block; };
      group.start[2 * kind + 1] = at += in_blocks(touching);
      group.start[2 * kind + 2] = at += in_blocks(pairs.size() - touching);
    }
    list.groups.push_back(group);
    order.push_back(&shared);
  };
  for (const std::size_t n : by_round) {
    if (round[n] == list.first_of_round.size()) list.first_of_round.push_back(list.groups.size());
    add(neighbours[n].a, *across[n]);
  }
  if (!across.empty()) list.first_of_round.push_back(list.groups.size());
  for (std::uint32_t a = 0; a < found.size(); ++a)
    for (const Shared& own : found[a].own) add(a, own);
  return order;
}

}  // namespace

template <int D>
PairList<D> list_pairs(const Bodies<D>& bodies, const Periodic<D>& box, double skin, const PairList<D>& old,
                       const std::vector<std::uint32_t>& old_id, const Parts& parts, const Kernels& kernels,
                       ThreadTeam& team) {
  double widest = 0;
  for (std::size_t k = 0; k < bodies.count(); ++k) widest = std::max(widest, bodies.radius(k));
  const CellGrid<D> grid(bodies, box, 2 * widest + skin);
  const Aligned<double> shifts = image_shifts<D>(box);
  std::vector<OfPart> found(parts.with_grains());
  team.run(found.size(), [&](std::size_t part) {
    found[part] = share<D>(bodies, PairSearch<D>(grid, shifts, skin, kernels), parts, part);
  });

  PairList<D> list;
  const std::vector<const Shared*> shared = lay_out<D>(list, found, parts);
  const std::size_t size = list.groups.back().start.back();
  list.i.resize(size), list.j.resize(size), list.shift.resize(size);
  list.mbar.assign(size, 0.0);
  list.springs.assign(size * PairList<D>::spring_size, 0.0);
  const KeptSprings<D> springs(old, bodies.grains);
  const std::vector<std::uint32_t> was = places_then(bodies.id, old_id);
  team.run(list.groups.size(), [&](std::size_t g) {
    const PairGroup& group = list.groups[g];
    for (std::size_t run = 0; run < pair_runs; ++run) {
      const std::size_t end = put<D>(list, group.start[run], shared[g]->found[run / 2], run % 2 == 0, parts.tile());
      for (std::size_t k = group.start[run]; k < end; ++k) {
        const std::uint32_t a = list.i[k], b = list.j[k];
        list.mbar[k] =
            b < bodies.grains ? bodies.mass[a] * bodies.mass[b] / (bodies.mass[a] + bodies.mass[b]) : bodies.mass[a];
        springs.fetch(was[a], b < bodies.grains ? was[b] : b, list.spring(k));
      }
      for (std::size_t k = end; k < group.start[run + 1]; ++k) {
        list.i[k] = bodies.nobody(group.a);
        list.j[k] = bodies.nobody(group.a) + 1;
        list.shift[k] = no_shift<D>;
      }
    }
  });
  return list;
}

template PairList<2> list_pairs<2>(const Bodies<2>&, const Periodic<2>&, double, const PairList<2>&,
                                   const std::vector<std::uint32_t>&, const Parts&, const Kernels&, ThreadTeam&);
template PairList<3> list_pairs<3>(const Bodies<3>&, const Periodic<3>&, double, const PairList<3>&,
                                   const std::vector<std::uint32_t>&, const Parts&, const Kernels&, ThreadTeam&);

}  // namespace jam
