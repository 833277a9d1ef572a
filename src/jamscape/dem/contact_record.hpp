// What the records of both engines have in common: a contact by the law function that the kernels use, and the ledger.
#pragma once

#include "jamscape/contact/law.hpp"
#include "jamscape/geometry/vec.hpp"
#include "jamscape/packing/packing.hpp"

namespace jam {

/// What has been booked since the start; see EnergyLedger.
struct Booked {
  double damped = 0;
  double rubbed = 0;  ///< Hertz laws: the whole work against tangential forces, with what their springs hold now
  double wall_work = 0, gravity_work = 0;
};

EnergyLedger ledger_of(const Booked& booked, double kinetic, const ElasticEnergy& elastic, NormalLaw kind);

template <int D>
struct Touching {
  Vec<D> n;        ///< from the first body to the second, or to the wall
  double x, mbar;  ///< overlap, reduced mass
  Vec<D> v;        ///< of the first relative to the second, at the contact but for `lw`
  Axial<D> lw;     ///< spins times levers
  Axial<D> spring;
};

template <int D>
Vec3 widen(const Vec<D>& a) {
  Vec3 b{};
  for (int c = 0; c < D; ++c) b[c] = a[c];
  return b;
}

/// Appends overlap, normal and forces of a contact, and its energy; returns the force on the first body.
template <int D, bool once>
Vec<D> append_forces(Contacts& out, ElasticEnergy& energy, const PairLaw<>& law, NormalLaw kind, const Touching<D>& t) {
  Axial<D> spring = t.spring;
  const auto f = with_law(kind, [&]<NormalLaw normal>() {
    energy.add<normal>(law, t.x, spring);
    return law.mu > 0 ? touch<D, normal, true, once>(law, t.n, t.x, t.mbar, t.v, t.lw, spring, 0.0)
                      : touch<D, normal, false, once>(law, t.n, t.x, t.mbar, t.v, t.lw, spring, 0.0);
  });
  Vec<D> tangential;
  if constexpr (D == 2)
    tangential = {-f.tangential * t.n[1], f.tangential * t.n[0]};
  else
    tangential = f.tangential;
  out.overlap.push_back(t.x);
  out.normal_force.push_back(f.normal);
  out.normal.push_back(widen<D>(t.n));
  out.tangential_force.push_back(widen<D>(tangential));
  out.sliding.push_back(law.mu > 0 && norm(tangential) >= f.limit * (1 - 1e-9));
  return (-f.normal) * t.n + tangential;
}

/// All arrays of contacts in the order of (i, j, part_i, part_j).
void sort_contacts(Contacts& contacts);

/// Throws the error of a bug: the contacts of a record and the forces of the step are not the same.
[[noreturn]] void refuse_sums(const std::string& body, std::int64_t step);

}  // namespace jam
