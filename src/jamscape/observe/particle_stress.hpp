// Stress of each body from its contact forces, wall contacts included (no kinetic part):
//
//   sigma_ab = (1/V) sum over its contacts of f_a l_b,
//
// f the force on the body, l from its centre to the contact point, V its own volume: of the union of a cluster's arms
// (in two dimensions too), of a sphere, the area of a disc. I_1 = trace, negative in compression; i = I_1/<I_1>, the
// mean over all bodies, rattlers (0) among them. Principal stresses are those of the symmetric part; asymmetry is the
// Frobenius norm of the antisymmetric part over that of sigma: 0 where the contacts exert no torque about the centre.
// Source: S3 Eq. 8, Fig. 8; theory sec. 4.
#pragma once

#include <array>
#include <vector>

#include "jamscape/observe/measure.hpp"

namespace jam {

/// sigma[a][b], not symmetrised.
using Tensor = std::array<Vec3, 3>;

/// Of each body; zero without contacts.
std::vector<Tensor> particle_stresses(const Packing& packing);

/// i of each body; 0 for all where the mean is 0.
std::vector<double> stress_ratios(const std::vector<Tensor>& stresses);

/// Eigenvalues of the symmetric part, increasing: the most compressive first. In two dimensions those of the plane, and
/// 0 last.
Vec3 principal_stresses(const Tensor& sigma, int dimension);

/// 0 without stress.
double asymmetry(const Tensor& sigma);

Measure particle_stress_measure();
Measure stress_distribution_measure();

}  // namespace jam
