#include "jamscape/dem/pair_list.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "jamscape/base/error.hpp"

namespace jam {
namespace {

constexpr std::size_t tile = 64;

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

/// Appends the touching or the near pairs of one kind, tile by tile.
template <int D>
void append(PairList<D>& list, const std::vector<std::uint32_t>& first, const std::vector<Found>& found,
            std::size_t grains, bool touching) {
  for (std::size_t from = 0; from < grains; from += tile) {
    const std::size_t to = std::min(grains, from + tile);
    std::array<std::uint32_t, tile> next;
    for (std::size_t a = from; a < to; ++a) next[a - from] = first[a];
    for (bool more = true; more;) {
      more = false;
      for (std::size_t a = from; a < to; ++a) {
        std::uint32_t& q = next[a - from];
        while (q < first[a + 1] && found[q].touching != touching) ++q;
        if (q == first[a + 1]) continue;
        more = true;
        list.i.push_back(static_cast<std::uint32_t>(a));
        list.j.push_back(found[q].j);
        list.shift.push_back(found[q].shift);
        ++q;
      }
    }
  }
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
                       const std::vector<std::uint32_t>& old_id) {
  double widest = 0;
  for (std::size_t k = 0; k < bodies.count(); ++k) widest = std::max(widest, bodies.radius(k));
  const Grid<D> grid(bodies, box, 2 * widest + skin);
  const Aligned<double> shifts = image_shifts<D>(box);

  std::array<std::vector<std::uint32_t>, pair_kinds> first;
  std::array<std::vector<Found>, pair_kinds> found;
  for (auto& f : first) f.assign(1, 0), f.reserve(bodies.grains + 1);
  found[0].reserve(old.size() + old.size() / 8);
  Search<D> search(grid, shifts, skin);
  for (std::size_t a = 0; a < bodies.grains; ++a) {
    for (const Found& f : search(bodies.row(a), static_cast<std::uint32_t>(a))) {
      const bool across = f.shift != (images<D> - 1) / 2;
      const PairKind kind = f.j >= bodies.grains ? PairKind::bead : across ? PairKind::across : PairKind::inner;
      found[static_cast<std::size_t>(kind)].push_back(f);
    }
    for (std::size_t kind = 0; kind < pair_kinds; ++kind)
      first[kind].push_back(static_cast<std::uint32_t>(found[kind].size()));
  }

  PairList<D> list;
  const std::size_t room = found[0].size() + found[1].size() + found[2].size() + pair_runs * block;
  list.i.reserve(room), list.j.reserve(room), list.shift.reserve(room);
  for (std::size_t run = 0; run < pair_runs; ++run) {
    append<D>(list, first[run / 2], found[run / 2], bodies.grains, run % 2 == 0);
    while (list.i.size() % block) {
      list.i.push_back(static_cast<std::uint32_t>(bodies.count()));
      list.j.push_back(static_cast<std::uint32_t>(bodies.count() + 1));
      list.shift.push_back((images<D> - 1) / 2);
    }
    list.start[run + 1] = list.i.size();
  }

  list.mbar.assign(list.size(), 0.0);
  list.springs.assign(list.size() * PairList<D>::spring_size, 0.0);
  const Springs<D> springs(old, bodies.grains);
  const std::vector<std::uint32_t> was = places_then(bodies.id, old_id);
  for (std::size_t k = 0; k < list.size(); ++k) {
    const std::uint32_t a = list.i[k], b = list.j[k];
    if (a >= bodies.grains) continue;
    list.mbar[k] =
        b < bodies.grains ? bodies.mass[a] * bodies.mass[b] / (bodies.mass[a] + bodies.mass[b]) : bodies.mass[a];
    springs.fetch(was[a], b < bodies.grains ? was[b] : b, list.spring(k));
  }
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
                                     const std::vector<std::uint32_t>&);                               \
  template std::vector<std::uint32_t> spatial_order<D>(const Bodies<D>&);
JAM_INSTANTIATE(2)
JAM_INSTANTIATE(3)

}  // namespace jam
