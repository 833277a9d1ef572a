#include "jamscape/observe/particle_stress.hpp"

#include <algorithm>
#include <cmath>

#include "jamscape/observe/bodies.hpp"
#include "jamscape/observe/contact_forces.hpp"
#include "jamscape/observe/entry.hpp"
#include "jamscape/observe/wall_margin.hpp"

namespace jam {
namespace {

double trace(const Tensor& s) { return s[0][0] + s[1][1] + s[2][2]; }

void add(Tensor& sum, const Vec3& force, const Vec3& arm) {
  for (int a = 0; a < 3; ++a) sum[static_cast<std::size_t>(a)] += force[a] * arm;
}

Tensor symmetric_part(const Tensor& s) {
  Tensor t = s;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b)
      t[a][static_cast<int>(b)] = 0.5 * (s[a][static_cast<int>(b)] + s[b][static_cast<int>(a)]);
  return t;
}

// Turns axes p and q so that their element vanishes (Jacobi).
void turn(Tensor& s, std::size_t p, std::size_t q) {
  const int ip = static_cast<int>(p), iq = static_cast<int>(q);
  if (s[p][iq] == 0) return;
  const double ratio = (s[q][iq] - s[p][ip]) / (2 * s[p][iq]);
  const double t = (ratio >= 0 ? 1 : -1) / (std::abs(ratio) + std::hypot(ratio, 1));
  const double c = 1 / std::hypot(t, 1), sine = t * c;
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = s[k][ip], y = s[k][iq];
    s[k][ip] = c * x - sine * y;
    s[k][iq] = sine * x + c * y;
  }
  for (int k = 0; k < 3; ++k) {
    const double x = s[p][k], y = s[q][k];
    s[p][k] = c * x - sine * y;
    s[q][k] = sine * x + c * y;
  }
  s[p][iq] = s[q][ip] = 0;
}

}  // namespace

std::vector<Tensor> particle_stresses(const Packing& packing) {
  const Contacts& k = packing.contacts;
  const std::vector<Vec3>& x = packing.grains.position;
  std::vector<Tensor> stress(packing.grains.size(), Tensor{});
  for (std::size_t c = 0; c < k.size(); ++c) {
    const Vec3 f = k.tangential_force[c] - k.normal_force[c] * k.normal[c], arm = k.point[c] - x[k.i[c]];
    add(stress[k.i[c]], f, arm);
    if (k.j[c] >= 0) add(stress[static_cast<std::size_t>(k.j[c])], -1.0 * f, arm - branch(packing, c));
  }
  for (std::size_t i = 0; i < stress.size(); ++i) {
    const double volume = body_volume(packing, i);
    for (Vec3& row : stress[i]) row = (volume > 0 ? 1 / volume : 0.0) * row;
  }
  return stress;
}

std::vector<double> stress_ratios(const std::vector<Tensor>& stresses) {
  std::vector<double> ratios;
  double sum = 0;
  for (const Tensor& s : stresses) {
    ratios.push_back(trace(s));
    sum += ratios.back();
  }
  const double mean = sum / static_cast<double>(std::max<std::size_t>(stresses.size(), 1));
  for (double& r : ratios) r = mean != 0 && r != 0 ? r / mean : 0;
  return ratios;
}

Vec3 principal_stresses(const Tensor& sigma, int dimension) {
  Tensor s = symmetric_part(sigma);
  if (dimension == 2) {
    turn(s, 0, 1);
    return {std::min(s[0][0], s[1][1]), std::max(s[0][0], s[1][1]), 0};
  }
  for (int sweep = 0; sweep < 8; ++sweep)  // converges quadratically
    for (const auto& [p, q] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) turn(s, p, q);
  Vec3 values{s[0][0], s[1][1], s[2][2]};
  std::sort(values.c, values.c + 3);
  return values;
}

double asymmetry(const Tensor& sigma) {
  const Tensor even = symmetric_part(sigma);
  double odd2 = 0, all2 = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const Vec3 odd = sigma[a] - even[a];
    odd2 += dot(odd, odd);
    all2 += dot(sigma[a], sigma[a]);
  }
  return all2 > 0 ? std::sqrt(odd2 / all2) : 0;
}

Measure particle_stress_measure() {
  const char* unit = "m d^(2-D)/tau_c^2";
  return rows_measure(
      {"particle_stress", "stress of each grain",
       "sigma_ab = (1/V) sum_c f_a l_b over the contacts of a grain, walls included: f the force on it, l from its "
       "centre to the contact point, V its volume (union of the arms of a cluster, in two dimensions too; the area of "
       "a "
       "disc). Negative in compression. i1 = trace, i = i1 over its mean over all grains. s1 <= s2 <= s3 are the "
       "eigenvalues of the symmetric part (in two dimensions those of the plane, and s3 = 0); the rest is asymmetry.",
       "S3 Eq. 8, Fig. 4b; theory sec. 4"},
      {{"grain", "", "id of the grain"},
       {"i1", unit,
        "trace, negative in compression; 0 without contacts (stresses of clusters in two dimensions: per "
        "volume, m/(d tau_c^2))"},
       {"i", "<I1>", "i1 over its mean"},
       {"s1", unit, "principal stress, the most compressive"},
       {"s2", unit, "principal stress"},
       {"s3", unit, "principal stress, the least compressive; 0 in two dimensions"},
       {"asymmetry", "", "norm of the antisymmetric part over that of all: the torque the contacts exert; 0 at rest"}},
      1, false, [](const Snapshot& s) {
        const Packing& p = s.packing();
        const std::vector<Tensor> stress = particle_stresses(p);
        const std::vector<double> ratio = stress_ratios(stress);
        std::vector<std::vector<double>> columns(7);
        for (std::size_t i = 0; i < stress.size(); ++i) {
          const Vec3 principal = principal_stresses(stress[i], p.dimension);
          const double row[] = {static_cast<double>(p.grains.id[i]),
                                trace(stress[i]),
                                ratio[i],
                                principal[0],
                                principal[1],
                                principal[2],
                                asymmetry(stress[i])};
          for (std::size_t k = 0; k < columns.size(); ++k) columns[k].push_back(row[k]);
        }
        return columns;
      });
}

Measure stress_distribution_measure() {
  Measure m =
      rows_measure({"stress_distribution", "distribution of the grains' stresses",
                    "P(i), i = I_1/<I_1> over all grains (rattlers have 0), without those whose centre is closer to a "
                    "wall than force_margin, I_1 the trace of a grain's stress (measure "
                    "particle_stress); bins as for contact_force_distribution. density = count/norm, norm = grains "
                    "times width of the "
                    "bin: what lies outside the bins counts in it.",
                    "S3 Fig. 8; theory sec. 4"},
                   {{"stress", "<I1>", "centre of the bin"},
                    {"density", "1/<I1>", "P(i)"},
                    {"count", "", "grains in the bin"},
                    {"norm", "<I1>", "all grains times the width of the bin"}},
                   1, true, [](const Snapshot& s) {
                     const Packing& p = s.packing();
                     const WallMargin margin(p, s.options());
                     const std::vector<Tensor> all = particle_stresses(p);
                     std::vector<Tensor> kept;
                     for (std::size_t i = 0; i < all.size(); ++i)
                       if (margin.keeps(p.grains.position[i])) kept.push_back(all[i]);
                     return distribution_columns(stress_ratios(kept), s.options());
                   });
  m.ratios = {{"density_pooled", "count", "norm", "P(i) of all grains of all realisations, i in means of each"}};
  return m;
}

}  // namespace jam
