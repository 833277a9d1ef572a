// Scenes of one or two bodies, shared by the physics tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "jamscape/contact/damping.hpp"
#include "jamscape/dem/engine.hpp"

namespace jam::scenes {

/// The law of S1 in its own units (k_n = pi^2/2, unit masses), restitution e, friction mu.
inline PairLaw<> s1_law(double e, double mu) {
  ContactOptions o;
  o.restitution = e;
  o.friction = mu;
  return grain_law(o, 1.0);
}

/// Two unit-diameter bodies of mass 1, i at rest at the origin, j coming along x with impact parameter 0.
template <int D>
EngineSetup<D> head_on(const PairLaw<>& law, double speed, double dt, Scheme scheme, double gap = 0.01) {
  EngineSetup<D> s;
  s.radius = {0.5, 0.5};
  s.mass = {1, 1};
  s.inertia = {(D == 2 ? 0.5 : 0.4) * 0.25, (D == 2 ? 0.5 : 0.4) * 0.25};
  s.position = {Vec<D>{}, Vec<D>{}};
  s.velocity = {Vec<D>{}, Vec<D>{}};
  s.position[1][0] = 1 + gap;
  s.velocity[0][0] = speed / 2;
  s.velocity[1][0] = -speed / 2;
  s.grain_law = s.wall_law = law;
  s.scheme = scheme;
  s.dt = dt;
  return s;
}

/// Runs until the bodies have touched and parted again; the record of the first instant apart.
template <int D>
Packing after_contact(Engine<D>& engine, std::int64_t most_steps = 200000) {
  bool touched = false;
  for (std::int64_t k = 0; k < most_steps; ++k) {
    engine.compute_forces();
    Packing p = engine.record();
    engine.advance();
    if (!p.contacts.i.empty()) touched = true;
    if (touched && p.contacts.i.empty()) return p;
  }
  return {};
}

struct Impact {
  double first = -1, last = -1;       ///< times of the first and last instants in contact
  double deepest = 0, strongest = 0;  ///< overlap, normal force
};

/// Watches the contact of two bodies over `steps` steps.
template <int D>
Impact watch(Engine<D>& engine, int steps) {
  Impact impact;
  for (int k = 0; k < steps; ++k) {
    engine.compute_forces();
    const Packing p = engine.record();
    if (!p.contacts.i.empty()) {
      if (impact.first < 0) impact.first = engine.time();
      impact.last = engine.time();
      impact.deepest = std::max(impact.deepest, p.contacts.overlap[0]);
      impact.strongest = std::max(impact.strongest, p.contacts.normal_force[0]);
    }
    engine.advance();
  }
  return impact;
}

}  // namespace jam::scenes
