#include "jamscape/dem/pair_list.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

template <int D>
constexpr std::uint32_t images = D == 2 ? 9 : 27;

/// A body as the search for pairs sees it.
template <int D>
struct Placed {
  std::array<double, D> x;
  double radius;
  std::uint32_t body;
};

/// Bodies sorted into cubic cells, as index ranges.
template <int D>
struct Grid {
  std::array<double, D> lo{}, inverse{};
  std::array<int, D> cells{};
  std::array<bool, D> periodic{};
  std::vector<std::uint32_t> first;
  std::vector<Placed<D>> placed;  ///< by cell, then by index

  Grid(const Bodies<D>& bodies, const Periodic<D>& box, double least) {
    for (int c = 0; c < D; ++c) {
      const auto e = static_cast<std::size_t>(c);
      double length = box.length[e];
      periodic[e] = length > 0;
      if (periodic[e]) {
        lo[e] = box.lo[e];
      } else {
        double hi = lo[e] = bodies.row(0)[c];
        for (std::size_t k = 1; k < bodies.count(); ++k) {
          lo[e] = std::min(lo[e], bodies.row(k)[c]);
          hi = std::max(hi, bodies.row(k)[c]);
        }
        length = std::max(hi - lo[e], least);
      }
      cells[e] = std::clamp(static_cast<int>(length / least), 1, 4096);
      if (periodic[e] && cells[e] < 3)
        throw usage_error("the periodic box is less than three grain diameters wide", {}, "more grains, or walls");
      inverse[e] = cells[e] / length;
    }
    const std::size_t total = std::accumulate(cells.begin(), cells.end(), std::size_t{1},
                                              [](std::size_t a, int b) { return a * static_cast<std::size_t>(b); });
    first.assign(total + 1, 0);
    std::vector<std::uint32_t> cell(bodies.count());
    for (std::size_t k = 0; k < bodies.count(); ++k) ++first[(cell[k] = index(coordinates(bodies.row(k)))) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    placed.resize(bodies.count());
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (std::size_t k = 0; k < bodies.count(); ++k) {
      Placed<D>& p = placed[next[cell[k]]++];
      std::copy_n(bodies.row(k), D, p.x.begin());
      p.radius = bodies.radius(k), p.body = static_cast<std::uint32_t>(k);
    }
  }

  std::array<int, D> coordinates(const double* x) const {
    std::array<int, D> at;
    for (std::size_t e = 0; e < D; ++e)
      at[e] = std::clamp(static_cast<int>((x[e] - lo[e]) * inverse[e]), 0, cells[e] - 1);
    return at;
  }
  std::uint32_t index(const std::array<int, D>& at) const {
    std::size_t n = 0;
    for (std::size_t e = D; e-- > 0;) n = n * static_cast<std::size_t>(cells[e]) + static_cast<std::size_t>(at[e]);
    return static_cast<std::uint32_t>(n);
  }
};

struct Found {
  std::uint32_t j, shift;
  bool touching;
};

/// The bodies after `a` in memory that are nearer than the sum of radii + skin, by neighbouring cell.
template <int D>
class Search {
 public:
  Search(const Grid<D>& grid, const Aligned<double>& shifts, double skin) : grid_(grid), shifts_(shifts), skin_(skin) {}

  std::span<const Found> operator()(const double* row, std::uint32_t a) {
    count_ = 0;
    const auto at = grid_.coordinates(row);
    bool inside = true;
    for (std::size_t e = 0; e < D; ++e) inside = inside && at[e] > 0 && at[e] + 1 < grid_.cells[e];
    if (inside) {  // cells side by side along the first axis are one range
      for (std::uint32_t s = 1; s < images<D>; s += 3) {
        const std::uint32_t c = grid_.index(neighbour(at, s));
        look(row, a, grid_.first[c - 1], grid_.first[c + 2], (images<D> - 1) / 2);
      }
    } else {
      for (std::uint32_t s = 0; s < images<D>; ++s) {
        std::array<int, D> cell = neighbour(at, s);
        std::uint32_t shift = 0, weight = 1;
        bool outside = false;
        for (std::size_t e = 0; e < D; ++e, weight *= 3) {
          std::uint32_t image = 1;
          if (cell[e] < 0 || cell[e] >= grid_.cells[e]) {
            if (!grid_.periodic[e]) outside = true;
            image = cell[e] < 0 ? 0 : 2;
            cell[e] += cell[e] < 0 ? grid_.cells[e] : -grid_.cells[e];
          }
          shift += weight * image;
        }
        if (outside) continue;
        const std::uint32_t c = grid_.index(cell);
        look(row, a, grid_.first[c], grid_.first[c + 1], shift);
      }
    }
    return {found_.data(), count_};
  }

 private:
  static std::array<int, D> neighbour(std::array<int, D> cell, std::uint32_t s) {
    const auto step = image_of<D>(s);
    for (std::size_t e = 0; e < D; ++e) cell[e] += step[e];
    return cell;
  }
  /// Every candidate is written, and the next one over it unless it was near: no branch to guess.
  void look(const double* x, std::uint32_t a, std::uint32_t from, std::uint32_t to, std::uint32_t shift) {
    if (found_.size() < count_ + (to - from)) found_.resize(2 * (count_ + (to - from)));
    Found* out = found_.data();
    const double* moved = shifts_.data() + 4 * shift;
    std::size_t n = count_;
    for (std::uint32_t q = from; q < to; ++q) {
      const Placed<D>& p = grid_.placed[q];
      double r2 = 0;
      for (std::size_t e = 0; e < D; ++e) {
        const double d = (p.x[e] + moved[e]) - x[e];
        r2 += d * d;
      }
      const double reach = x[Row<D>::radius] + p.radius, far = reach + skin_;
      out[n] = {p.body, shift, r2 < reach * reach};
      n += static_cast<std::size_t>(r2 < far * far) & static_cast<std::size_t>(p.body > a);
    }
    count_ = n;
  }

  const Grid<D>& grid_;
  const Aligned<double>& shifts_;
  double skin_;
  std::vector<Found> found_;
  std::size_t count_ = 0;
};

/// The springs of an old list by the places of its bodies at that time.
template <int D>
class Springs {
 public:
  Springs(const PairList<D>& old, std::size_t grains) : old_(old) {
    first_.assign(grains + 1, 0);
    std::vector<std::size_t> held;
    held.reserve(old.touching() + old.touching() / 8);
    for (std::size_t k = 0; k < old.size(); ++k) {
      bool any = false;
      for (std::size_t c = 0; c < PairList<D>::spring_size; ++c) any |= old.spring(k)[c * block] != 0;
      if (!any) continue;
      held.push_back(k);
      ++first_[old.i[k] + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    partner_.resize(held.size());
    pair_.resize(held.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (const std::size_t k : held) {
      const std::uint32_t at = next[old.i[k]]++;
      partner_[at] = old.j[k];
      pair_[at] = k;
    }
  }

  /// Copies the spring of the pair (a, b), if there is one, into `to` (stride `block`).
  void fetch(std::uint32_t a, std::uint32_t b, double* to) const {
    if (!copy(a, b, 1.0, to) && b + 1 < first_.size()) copy(b, a, D == 2 ? 1.0 : -1.0, to);
  }

 private:
  bool copy(std::uint32_t a, std::uint32_t b, double sign, double* to) const {
    for (std::uint32_t q = first_[a]; q < first_[a + 1]; ++q)
      if (partner_[q] == b) {
        for (std::size_t c = 0; c < PairList<D>::spring_size; ++c)
          to[c * block] = sign * old_.spring(pair_[q])[c * block];
        return true;
      }
    return false;
  }

  const PairList<D>& old_;
  std::vector<std::uint32_t> first_, partner_;
  std::vector<std::size_t> pair_;
};

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

/// The pairs of a part with one other (or itself), by kind, i not descending.
struct Shared {
  std::uint32_t with;
  std::array<std::vector<Near>, pair_kinds> found{};
};

/// Writes the touching or the near ones of `found` to the list from `at` on, tile by tile. Returns where they end.
template <int D>
std::size_t put(PairList<D>& list, std::size_t at, const std::vector<Near>& found, bool touching) {
  std::array<std::size_t, Parts::tile> next, end;
  for (std::size_t from = 0; from < found.size();) {
    const std::uint32_t tile = found[from].i / Parts::tile;
    std::size_t grains = 0, q = from;
    for (; q < found.size() && found[q].i / Parts::tile == tile; ++q) {
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

/// What a part shares with itself, then with others of higher index, in the order found.
template <int D>
std::vector<Shared> share(const Bodies<D>& bodies, Search<D> search, const Parts& parts, std::size_t part) {
  std::vector<Shared> all{{static_cast<std::uint32_t>(part)}};
  const auto shared_with = [&](std::uint32_t other) -> Shared& {
    for (Shared& s : all)
      if (s.with == other) return s;
    return all.emplace_back(Shared{other});
  };
  const auto [begin, end] = parts.grains(part);
  all[0].found[0].reserve((end - begin) * (D == 2 ? 4 : 9));
  for (std::size_t k = begin; k < end; ++k) {
    const auto a = static_cast<std::uint32_t>(k);
    for (const Found& f : search(bodies.row(k), a)) {
      const bool across = f.shift != (images<D> - 1) / 2;
      const PairKind kind = f.j >= bodies.grains ? PairKind::bead : across ? PairKind::across : PairKind::inner;
      const std::uint32_t other = parts.of(f.j);
      Shared& to = other == part ? all[0] : shared_with(other);
      to.found[static_cast<std::size_t>(kind)].push_back({a, f.j, f.shift, f.touching});
    }
  }
  return all;
}

/// Lays out the groups of a list, and says for each which pairs found belong to it.
template <int D>
std::vector<const Shared*> lay_out(PairList<D>& list, const std::vector<std::vector<Shared>>& found,
                                   const Parts& parts) {
  struct Entry {
    std::uint32_t round, a;
    const Shared* shared;
  };
  std::vector<Entry> entries;
  std::vector<Neighbours> neighbours;
  for (std::uint32_t a = 0; a < found.size(); ++a)
    for (const Shared& s : found[a]) {
      entries.push_back({0, a, &s});
      if (s.with != a) neighbours.push_back({a, s.with, s.found[0].size() + s.found[1].size() + s.found[2].size()});
    }
  const std::vector<std::uint32_t> rounds = deal_rounds(neighbours, parts.size());
  std::size_t next = 0;
  for (Entry& e : entries)
    if (e.shared->with != e.a) e.round = 1 + rounds[next++];
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& p, const Entry& q) { return p.round < q.round; });

  std::vector<const Shared*> order;
  std::size_t at = 0;
  for (const Entry& e : entries) {
    if (e.round == list.first_of_round.size()) list.first_of_round.push_back(list.groups.size());
    PairGroup group{e.a, e.shared->with, {at}};
    for (std::size_t kind = 0; kind < pair_kinds; ++kind) {
      const auto& pairs = e.shared->found[kind];
      const auto touching =
          static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), [](const Near& f) { return f.touching; }));
      const auto in_blocks = [](std::size_t n) { return (n + block - 1) / block * block; };
      group.start[2 * kind + 1] = at += in_blocks(touching);
      group.start[2 * kind + 2] = at += in_blocks(pairs.size() - touching);
    }
    list.groups.push_back(group);
    order.push_back(e.shared);
  }
  list.first_of_round.push_back(list.groups.size());
  return order;
}

}  // namespace

template <int D>
Aligned<double> image_shifts(const Periodic<D>& box) {
  Aligned<double> rows(images<D> * 4, 0.0);
  for (std::uint32_t s = 0; s < images<D>; ++s) {
    const auto image = image_of<D>(s);
    for (std::size_t e = 0; e < D; ++e) rows[4 * s + e] = image[e] * box.length[e];
  }
  return rows;
}

template <int D>
std::array<std::int8_t, 3> image_of(std::uint32_t shift) {
  std::array<std::int8_t, 3> image{};
  for (std::size_t e = 0; e < D; ++e, shift /= 3) image[e] = static_cast<std::int8_t>(static_cast<int>(shift % 3) - 1);
  return image;
}

template <int D>
PairList<D> list_pairs(const Bodies<D>& bodies, const Periodic<D>& box, double skin, const PairList<D>& old,
                       const std::vector<std::uint32_t>& old_id, const Parts& parts, ThreadTeam& team) {
  double widest = 0;
  for (std::size_t k = 0; k < bodies.count(); ++k) widest = std::max(widest, bodies.radius(k));
  const Grid<D> grid(bodies, box, 2 * widest + skin);
  const Aligned<double> shifts = image_shifts<D>(box);
  std::vector<std::vector<Shared>> found(parts.with_grains());
  team.run(found.size(),
           [&](std::size_t part) { found[part] = share<D>(bodies, Search<D>(grid, shifts, skin), parts, part); });

  PairList<D> list;
  const std::vector<const Shared*> shared = lay_out<D>(list, found, parts);
  const std::size_t size = list.groups.back().start.back();
  list.i.resize(size), list.j.resize(size), list.shift.resize(size);
  list.mbar.assign(size, 0.0);
  list.springs.assign(size * PairList<D>::spring_size, 0.0);
  const Springs<D> springs(old, bodies.grains);
  const std::vector<std::uint32_t> was = places_then(bodies.id, old_id);
  team.run(list.groups.size(), [&](std::size_t g) {
    const PairGroup& group = list.groups[g];
    for (std::size_t run = 0; run < pair_runs; ++run) {
      const std::size_t end = put<D>(list, group.start[run], shared[g]->found[run / 2], run % 2 == 0);
      for (std::size_t k = group.start[run]; k < end; ++k) {
        const std::uint32_t a = list.i[k], b = list.j[k];
        list.mbar[k] =
            b < bodies.grains ? bodies.mass[a] * bodies.mass[b] / (bodies.mass[a] + bodies.mass[b]) : bodies.mass[a];
        springs.fetch(was[a], b < bodies.grains ? was[b] : b, list.spring(k));
      }
      for (std::size_t k = end; k < group.start[run + 1]; ++k) {
        list.i[k] = bodies.nobody(group.a);
        list.j[k] = bodies.nobody(group.a) + 1;
        list.shift[k] = (images<D> - 1) / 2;
      }
    }
  });
  return list;
}

template <int D>
std::vector<std::uint32_t> spatial_order(const Bodies<D>& bodies) {
  double widest = 0;
  for (std::size_t k = 0; k < bodies.grains; ++k) widest = std::max(widest, bodies.radius(k));
  const Grid<D> grid(bodies, Periodic<D>{}, std::max(2 * widest, 1e-300));
  std::vector<std::uint64_t> key(bodies.grains);
  for (std::size_t k = 0; k < bodies.grains; ++k) {
    const auto at = grid.coordinates(bodies.row(k));
    for (int bit = 0; bit < 12; ++bit)
      for (std::size_t e = 0; e < D; ++e)
        key[k] |= static_cast<std::uint64_t>((at[e] >> bit) & 1) << (static_cast<std::size_t>(bit) * D + e);
  }
  std::vector<std::uint32_t> order(bodies.grains);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key[a] < key[b]; });
  return order;
}

#define JAM_INSTANTIATE(D)                                                                             \
  template Aligned<double> image_shifts<D>(const Periodic<D>&);                                        \
  template std::array<std::int8_t, 3> image_of<D>(std::uint32_t);                                      \
  template PairList<D> list_pairs<D>(const Bodies<D>&, const Periodic<D>&, double, const PairList<D>&, \
                                     const std::vector<std::uint32_t>&, const Parts&, ThreadTeam&);    \
  template std::vector<std::uint32_t> spatial_order<D>(const Bodies<D>&);
JAM_INSTANTIATE(2)
JAM_INSTANTIATE(3)

}  // namespace jam
