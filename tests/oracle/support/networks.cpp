#include "networks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace jam::examples {
namespace {

using Point = std::array<double, 3>;
using Links = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

double square(const Point& d) { return d[0] * d[0] + d[1] * d[1] + d[2] * d[2]; }

/// Calls f(i, j, x_j - x_i) once for every pair of points of the unit box nearer than `reach`.
template <class F>
void near_pairs(const std::vector<Point>& x, int dimension, double reach, bool periodic, F&& f) {
  const int n = std::max(1, std::min(static_cast<int>(1 / reach), dimension == 2 ? 1000 : 100));
  const int nz = dimension == 3 ? n : 1;
  std::vector<std::vector<std::uint32_t>> cells(static_cast<std::size_t>(n * n * nz));
  const auto place = [&](double c) { return std::clamp(static_cast<int>(c * n), 0, n - 1); };
  const auto cell = [&](int a, int b, int c) -> auto& { return cells[static_cast<std::size_t>((c * n + b) * n + a)]; };
  for (std::uint32_t i = 0; i < x.size(); ++i) {
    cell(place(x[i][0]), place(x[i][1]), nz > 1 ? place(x[i][2]) : 0).push_back(i);
  }
  const auto test = [&](std::uint32_t i, std::uint32_t j) {
    Point d{};
    for (std::size_t k = 0; k < 3; ++k) {
      d[k] = x[j][k] - x[i][k];
      if (periodic && (k < 2 || dimension == 3)) d[k] -= std::round(d[k]);
    }
    if (square(d) < reach * reach) f(i, j, d);
  };
  if (n < 3) {
    for (std::uint32_t i = 0; i < x.size(); ++i) {
      for (std::uint32_t j = i + 1; j < x.size(); ++j) test(i, j);
    }
    return;
  }
  for (int c = 0; c < nz; ++c) {
    for (int b = 0; b < n; ++b) {
      for (int a = 0; a < n; ++a) {
        for (int dc = nz > 1 ? -1 : 0; dc <= (nz > 1 ? 1 : 0); ++dc) {
          for (int db = -1; db <= 1; ++db) {
            for (int da = -1; da <= 1; ++da) {
              const std::array<int, 3> to{a + da, b + db, c + dc};
              const auto outside = [&](int p, int m) { return p < 0 || p >= m; };
              if (!periodic && (outside(to[0], n) || outside(to[1], n) || outside(to[2], nz))) continue;
              for (const auto i : cell(a, b, c)) {
                for (const auto j : cell((to[0] + n) % n, (to[1] + n) % n, (to[2] + nz) % nz)) {
                  if (i < j) test(i, j);
                }
              }
            }
          }
        }
      }
    }
  }
}

std::vector<Point> random_points(std::uint32_t n, int dimension, Random& random) {
  std::vector<Point> x(n);
  for (auto& p : x) {
    p = {random.uniform(), random.uniform(), dimension == 3 ? random.uniform() : 0};
  }
  return x;
}

}  // namespace

Random stream(std::uint64_t seed) { return {seed, "examples", 0, "network"}; }

Weights forces() {
  return [](Random& random) { return -.5 * (std::log(1 - random.uniform()) + std::log(1 - random.uniform())); };
}

Weights levels(int levels) {
  return [levels](Random& random) {
    return static_cast<double>(random.below(static_cast<std::uint64_t>(levels))) / (levels - 1);
  };
}

WeightedGraph graph(std::uint32_t vertices, const Links& links, const Weights& weights, Random& random) {
  WeightedGraph g{vertices, {}, {}, {}};
  for (const auto& [i, j] : links) {
    g.from.push_back(i);
    g.to.push_back(j);
    g.weight.push_back(weights(random));
  }
  return g;
}

WeightedGraph erdos_renyi(std::uint32_t vertices, double p, const Weights& weights, std::uint64_t seed) {
  auto random = stream(seed);
  Links links;
  for (std::uint32_t i = 0; i < vertices; ++i) {
    for (std::uint32_t j = i + 1; j < vertices; ++j) {
      if (random.uniform() < p) links.emplace_back(i, j);
    }
  }
  return graph(vertices, links, weights, random);
}

WeightedGraph geometric(std::uint32_t vertices, int dimension, double distance, const Weights& weights,
                        std::uint64_t seed) {
  auto random = stream(seed);
  const auto x = random_points(vertices, dimension, random);
  Links links;
  near_pairs(x, dimension, distance, false,
             [&](std::uint32_t i, std::uint32_t j, const Point&) { links.emplace_back(i, j); });
  return graph(vertices, links, weights, random);
}

WeightedGraph lattice(Lattice kind, std::uint32_t vertices, double kept, const Weights& weights, std::uint64_t seed) {
  auto random = stream(seed);
  const bool flat = kind != Lattice::cubic && kind != Lattice::fcc;
  const auto side = static_cast<int>(std::max(2.0, std::round(flat ? std::sqrt(vertices) : std::cbrt(vertices))));
  std::vector<Point> x;
  double nearest = 1;
  for (int c = 0; c < (flat ? 1 : side); ++c) {
    for (int b = 0; b < side; ++b) {
      for (int a = 0; a < side; ++a) {
        switch (kind) {
          case Lattice::square:
          case Lattice::cubic:
            x.push_back({double(a), double(b), double(c)});
            break;
          case Lattice::triangular:
            x.push_back({a + .5 * (b % 2), b * std::numbers::sqrt3 / 2, 0});
            break;
          case Lattice::honeycomb:  // a brick wall of unit bonds, each row shifted to meet every second site of the
                                    // next
            if ((a + b) % 2 == 0) {
              x.push_back({a * std::numbers::sqrt3 / 2, b * 1.5, 0});
              x.push_back({a * std::numbers::sqrt3 / 2, b * 1.5 + 1, 0});
            }
            break;
          case Lattice::fcc:
            if ((a + b + c) % 2 == 0) x.push_back({double(a), double(b), double(c)});
            nearest = std::numbers::sqrt2;
            break;
        }
      }
    }
  }
  Links links;
  for (std::uint32_t i = 0; i < x.size(); ++i) {
    for (std::uint32_t j = i + 1; j < x.size(); ++j) {
      const Point d{x[j][0] - x[i][0], x[j][1] - x[i][1], x[j][2] - x[i][2]};
      if (square(d) < 1.1 * nearest * nearest && random.uniform() < kept) links.emplace_back(i, j);
    }
  }
  return graph(static_cast<std::uint32_t>(x.size()), links, weights, random);
}

WeightedGraph packing(std::uint32_t grains, int dimension, double packing_fraction, int steps, std::uint64_t seed) {
  auto random = stream(seed);
  auto x = random_points(grains, dimension, random);
  std::sort(x.begin(), x.end(), [](const Point& p, const Point& q) {  // rows: neighbours get near numbers
    return std::pair(std::floor(p[1] * 40), p[0]) < std::pair(std::floor(q[1] * 40), q[0]);
  });
  std::vector<double> radius(grains);
  double filled = 0;
  for (auto& r : radius) {
    r = random.below(3) == 0 ? 1.4 : 1;
    filled += dimension == 2 ? std::numbers::pi * r * r : 4 * std::numbers::pi / 3 * r * r * r;
  }
  const double scale = std::pow(packing_fraction / filled, 1.0 / dimension);
  for (auto& r : radius) r *= scale;
  const double reach = 2.8 * scale;

  const auto touching = [&](auto&& f) {
    near_pairs(x, dimension, reach, true, [&](std::uint32_t i, std::uint32_t j, const Point& d) {
      const double distance = std::sqrt(square(d)), overlap = radius[i] + radius[j] - distance;
      if (overlap >= 0) f(i, j, d, overlap, std::max(distance, 1e-12));
    });
  };
  std::vector<Point> push(grains);
  for (int step = 0; step < steps; ++step) {
    std::fill(push.begin(), push.end(), Point{});
    touching([&](std::uint32_t i, std::uint32_t j, const Point& d, double overlap, double distance) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double move = .3 * overlap * d[k] / distance;
        push[i][k] -= move;
        push[j][k] += move;
      }
    });
    for (std::uint32_t i = 0; i < grains; ++i) {
      for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
        x[i][k] += push[i][k];
        x[i][k] -= std::floor(x[i][k]);
      }
    }
  }
  WeightedGraph g{grains, {}, {}, {}};
  touching([&](std::uint32_t i, std::uint32_t j, const Point&, double overlap, double) {
    g.from.push_back(i);
    g.to.push_back(j);
    g.weight.push_back(overlap);
  });
  const double mean = std::accumulate(g.weight.begin(), g.weight.end(), 0.0) / static_cast<double>(g.edges());
  for (auto& w : g.weight) w /= mean;
  return g;
}

WeightedGraph clamped(WeightedGraph graph, double most) {
  for (auto& w : graph.weight) w = std::min(w, most);
  return graph;
}

WeightedGraph shuffled(const WeightedGraph& graph, std::uint32_t extra, std::uint64_t seed) {
  auto random = stream(seed);
  const auto permutation = [&](std::size_t n) {
    std::vector<std::uint32_t> p(n);
    std::iota(p.begin(), p.end(), 0u);
    for (std::size_t i = n; i > 1; --i) std::swap(p[i - 1], p[random.below(i)]);
    return p;
  };
  WeightedGraph g{graph.vertices + extra, {}, {}, {}};
  const auto vertex = permutation(g.vertices);
  for (const auto e : permutation(graph.edges())) {
    const auto a = vertex[graph.from[e]], b = vertex[graph.to[e]];
    const bool turned = random.below(2) == 1;
    g.from.push_back(turned ? b : a);
    g.to.push_back(turned ? a : b);
    g.weight.push_back(graph.weight[e]);
  }
  return g;
}

WeightedGraph side_by_side(const WeightedGraph& a, const WeightedGraph& b) {
  WeightedGraph g = a;
  g.vertices += b.vertices;
  for (std::size_t e = 0; e < b.edges(); ++e) {
    g.from.push_back(a.vertices + b.from[e]);
    g.to.push_back(a.vertices + b.to[e]);
    g.weight.push_back(b.weight[e]);
  }
  return g;
}

}  // namespace jam::examples
