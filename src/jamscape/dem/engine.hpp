// One simulation in motion: bodies, pair list, walls and the clock.
//
//   run(n)             n steps: the forces of an instant, and the motion to the next; a stretch of grains is moved as
//                      soon as the forces on it are known
//   compute_forces()   the forces of this instant alone. They are kept until the clock goes on: whoever asks again, for
//                      them or for a record, books nothing twice, and run() goes on from them
//
// Energies are booked with the forces, so that the ledger of a record closes to the integrator's order.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "jamscape/base/archive.hpp"
#include "jamscape/base/thread_team.hpp"
#include "jamscape/contact/law.hpp"
#include "jamscape/dem/bodies.hpp"
#include "jamscape/dem/contact_record.hpp"
#include "jamscape/dem/diverged.hpp"
#include "jamscape/dem/kernel.hpp"
#include "jamscape/dem/pair_list.hpp"
#include "jamscape/dem/parts.hpp"
#include "jamscape/dem/scheme.hpp"
#include "jamscape/packing/packing.hpp"

namespace jam {

/// A wall across one axis: a plane, or a row of beads that moves as one piece along its normal.
template <int D>
struct EngineWall {
  WallKind kind = WallKind::plane;
  int axis = 0;
  bool high = false;    ///< at the upper end of the axis: its normal points down the axis
  double position = 0;  ///< of the plane, or of the bead centres
  double velocity = 0;  ///< along the axis
  double bead_radius = 0;
  std::vector<Vec<D>> beads;  ///< at the start
  /// Beads that close up with the box: their place along the row, -1/2 .. 1/2 from corner to corner. Empty: a rigid
  /// row.
  std::vector<double> along{};
};

/// What an engine is made of. Arrays by grain id.
template <int D>
struct EngineSetup {
  std::vector<double> radius, mass, inertia;
  std::vector<std::int32_t> species;
  std::vector<Vec<D>> position, velocity;
  std::vector<Axial<D>> spin;  ///< empty: at rest
  std::vector<EngineWall<D>> walls;
  Periodic<D> box;
  Vec<D> gravity{};  ///< acceleration of the grains
  NormalLaw kind = NormalLaw::linear;
  PairLaw<> grain_law{}, wall_law{};
  SpringTurn spring_turn = SpringTurn::projected;
  Scheme scheme = Scheme::verlet;
  double dt = 0.02;
};

template <int D>
class Engine {
 public:
  explicit Engine(const EngineSetup<D>& setup, const Kernels& kernels = best_kernels());

  /// Threads that share a step from now on, as many of those wanted as are of use (see Parts); returns how many that
  /// are. They change no bit.
  int set_threads(int wanted);

  /// Forces at the present positions and half-step (Verlet) or predicted (Gear) velocities, unless they are known.
  /// Throws Diverged.
  void compute_forces();
  /// One time step.
  void advance() { run(1); }
  /// `n` time steps. Throws Diverged.
  void run(std::int64_t n);

  /// This instant in full. Checks the contacts against the forces, and that no grain is outside the box; throws
  /// Diverged.
  Packing record();

  /// Translation and rotation, with the velocities the forces see (Verlet: half a step behind).
  double kinetic_energy() const;
  /// Of all contacts at the present positions.
  ElasticEnergy elastic_energy() const;

  std::int64_t step() const { return step_; }
  double time() const { return static_cast<double>(step_) * dt_; }
  std::size_t grains() const { return bodies_.grains; }
  const std::vector<EngineWall<D>>& walls() const { return walls_; }
  const Periodic<D>& box() const { return box_; }
  void set_wall_velocity(std::size_t wall, double velocity);
  /// A periodic box, a square or a cube, shortens by 2 `speed` a unit of time in every direction, and the grains'
  /// positions with it. Their velocities are those beside that motion; the dashpots feel both.
  void set_box_speed(double speed) { box_speed_ = speed; }
  /// Finds numbers that are none, bodies pressed through each other and grains outside the box; throws Diverged.
  void check() const;

  /// Everything that determines what follows, bit for bit.
  void save(Archive& archive) const;
  /// Into an engine of the same setup; throws a data error if the archive is of another.
  void load(const Archive& archive);

 private:
  /// What the bodies and pairs of a part add to; by part, so that threads share nothing and the order of sums is fixed.
  struct alignas(64) Sums {
    Tally tally{};
    double gravity_power = 0;
    std::array<double, 4> fastest{};  ///< see BodyArrays
    std::vector<Vec<D>> wall_force;   ///< of planes
  };

  /// A simulation is given up when two bodies overlap by more than this part of the smaller radius. A grain pinned in
  /// the corner of two bead walls may come near it in earnest; beyond, it is between the beads and about to leave the
  /// box.
  static constexpr double deepest_overlap = 1.0;

  void make_step();
  void relist();
  PairArrays pair_arrays(std::size_t part);
  PairRange range_of(std::size_t group, std::size_t run) const;
  void watch_near();
  void begin_sums();
  void twirl_springs();
  void sum_pairs(std::size_t group);
  void sum_own(std::size_t part, bool move);
  void touch_planes(std::size_t part, std::size_t stretch);
  void pull_down(std::size_t part, std::size_t stretch);
  void collect_beads();
  void add_up();
  void move_bodies(std::size_t part, std::size_t stretch);
  void end_step();
  void shrink_box();
  double closing_in_a_step(double speed2) const;
  /// See PairArrays.
  double shrinking() const { return box_speed_ == 0 ? 0 : 2 * box_speed_ / box_.length[0]; }
  double fastest_plane() const;
  void check_inside() const;
  void check_speed(double bound) const;
  std::string likely_cause(const std::string& otherwise) const;
  [[noreturn]] void fail(std::size_t body, const std::string& problem,
                         const std::string& otherwise = "grains or walls are too fast for the stiffness") const;

  const Kernels* kernels_;
  NormalLaw kind_;
  PairLaw<> grain_law_, wall_law_;
  SpringTurn spring_turn_;
  Scheme scheme_;
  double dt_, smallest_ = 0, largest_ = 0, diameter_ = 1;

  Bodies<D> bodies_;
  Parts parts_;
  std::unique_ptr<ThreadTeam> team_ = std::make_unique<ThreadTeam>();
  std::vector<Sums> sums_;  ///< by part with grains
  std::vector<EngineWall<D>> walls_;
  std::vector<std::size_t> first_bead_;  ///< of each wall, a body index
  std::vector<Vec<D>> wall_force_;       ///< at this instant, where the forces are known; else 0
  Periodic<D> box_;
  double box_speed_ = 0;
  Vec<D> gravity_{};

  PairList<D> pairs_;
  Aligned<double> shifts_;
  // near pairs that may touch before a body has gone farther than watch_until_: found anew then
  Aligned<std::uint32_t> watch_i_, watch_j_, watch_shift_, watch_pair_;
  std::vector<std::uint8_t> watch_touching_;
  std::vector<std::array<std::size_t, pair_runs>> watched_;  ///< by group of pairs
  double watch_until_ = -1, closing_ = 0;  ///< closing_: how much nearer two bodies came in the last step at most
  bool few_pushed_ = false;                ///< see BodyArrays; of the present list
  // plane contacts, by stretch, wall, grain
  std::vector<std::size_t> first_plane_;  ///< of each stretch, and the end
  std::vector<std::uint32_t> plane_grain_, plane_wall_;
  std::vector<Axial<D>> plane_spring_;

  std::int64_t step_ = 0;
  double skin_ = 0, moved_ = 0;  ///< moved_: no body has gone farther since the list was made
  double planes_moved_ = 0;      ///< and no plane
  bool stale_ = true;
  bool summed_ = false;     ///< the forces of this instant are known, and booked
  std::int64_t lists_ = 0;  ///< made so far; grains are reordered at some of them
  Booked booked_;
};

extern template class Engine<2>;
extern template class Engine<3>;

}  // namespace jam
