// Stored frames: one frame a file while a task runs, one file of all frames when it has ended. Both have the same
// layout, and every number comes back with its exact bits (a zero out of the plane of a 2D packing comes back as +0).
//
// Layout, version 2 (T frames, N grains at most, D dimensions, C contacts, W walls and B beads over all frames; S is 1
// for 2D, 3 for 3D; clusters have K shapes of A arms in all). The grains are an H5MD 1.1 particle group; step and time
// are one array under many names.
//   /h5md                              version, author, creator
//   /frames                            step i64[T], time f64[T], stage string[T]; relaxation string[T] where frames
//                                      have it
//   /particles/all/box                 attributes dimension, boundary; edges/{step,time,value[T][D]};
//                                      lower, upper f64[T][3], periodic u8[T][3]
//   /particles/all/count/{step,time,value}       grains in each frame; the rest of a row is padding
//   /particles/all/{position,velocity}/{step,time,value[T][N][D]}
//   /particles/all/{angular_velocity,angle}/{step,time,value[T][N][S]}
//   /particles/all/{id,species,radius,mass}      [N], or {step,time,value[T][N]} when they change
//   clusters only: /particles/all/{shape i32,scale}   [N], or {step,time,value[T][N]} when they change
//                  /particles/all/orientation/{step,time,value[T][N][4]}   unit quaternions w, x, y, z
//                  /shapes   name string[K], volume, surface, area, length, circumradius f64[K], inertia f64[K][3],
//                            arm_offset u64[K+1], arm_{centre,direction} f64[A][3], arm_{half_length,radius} f64[A]
//   /contacts    step, time, offset u64[T+1] (frame t has the rows offset[t] to offset[t+1]-1), i u32, j i32 (wall w:
//                -1-w), part_i u16, part_j u16, image i8[C][D], overlap, fn f64, normal, ft, point f64[C][D], slip u8
//   /walls       step, time, offset u64[T+1], kind u8 (0 plane, 1 beads, 2 cylinder), position, normal, velocity,
//                force f64[W][3], bead_radius f64, cylinder_radius f64 (since version 2), bead_offset u64[W+1], bead
//                f64[B][3]
//   /observables/{packing_fraction,packing_fraction_plain,energy_kinetic,...}/{step,time,value[T]}
//   /parameters  attributes program, version and others; config string
// Every group carries the attribute layout_version. Text that is read back is of fixed length (hdf5.hpp says why).
//
// Behind the HDF5 file stands a seal (seal.hpp) over all its bytes, and the root attribute `sealed` says that it does:
// a bit turned anywhere, a cut, or a change by another program is found before anything is read. Files without that
// attribute were written before run files were sealed (frame files always were); only their larger arrays carry
// checksums.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "jamscape/packing/packing.hpp"

namespace jam {

/// Where a run came from. Nothing in it may differ between two runs that ought to be equal (no times, no host names).
struct Provenance {
  std::string study;                           ///< the resolved study, as text
  std::string version;                         ///< of the program
  std::map<std::string, std::string> further;  ///< seed, realisation, git hash, compiler, ...
  bool operator==(const Provenance&) const = default;
};

/// A file of one frame, sealed (seal.hpp), written aside, forced to the disk and renamed: whole or absent. Throws a
/// data error for a full disk or any other failure.
void write_frame(const std::filesystem::path& path, const Packing& packing);

/// Throws a data error for a file that is missing, truncated, damaged, or not of one frame.
Packing read_frame(const std::filesystem::path& path);

/// Puts frame files together, in the order given; written aside, sealed, forced to the disk and renamed. Only one frame
/// at a time is held in memory. All frames have the same dimension and the same shapes; the grains may change in
/// number.
void assemble_run(const std::vector<std::filesystem::path>& frames, const std::filesystem::path& run_h5,
                  const Provenance& provenance);

/// What is known of a run file after a look at all its bytes.
struct RunCheck {
  enum class Verdict {
    whole,
    not_covered,  ///< readable, but written before run files were sealed: damage to small arrays would not be seen
    damaged,
    unreadable,  ///< not there, not permitted, or of a later version of the program: nothing is known
  };
  Verdict verdict = Verdict::whole;
  std::string reason;  ///< of the last two, with the name of the file

  bool usable() const { return verdict == Verdict::whole || verdict == Verdict::not_covered; }
};

RunCheck check_run(const std::filesystem::path& path);

/// How much is looked at before a run file is read: all its bytes, or what a file that check_run() has passed needs.
enum class Look { content, structure };

/// A run.h5, open to read frame by frame. Safe to use from several threads.
class RunFile {
 public:
  /// Throws a data error for a file that is missing, truncated, damaged, or of another kind.
  explicit RunFile(const std::filesystem::path& path, Look look = Look::content);
  ~RunFile();
  RunFile(RunFile&&) noexcept;
  RunFile& operator=(RunFile&&) noexcept;

  std::size_t frames() const;
  const std::vector<std::int64_t>& steps() const;
  const std::vector<double>& times() const;
  const std::vector<std::string>& stages() const;
  const std::vector<std::string>& relaxations() const;  ///< Packing::relaxation of each frame
  const std::vector<double>& packing_fractions() const;
  const std::vector<ClusterShape>& shapes() const;  ///< of all frames; empty for discs and spheres
  Provenance provenance() const;

  /// Throws a data error for a frame there is not, or a damaged one: what it returns has contacts that name grains and
  /// walls there are, and clusters of shapes there are.
  Packing frame(std::size_t k) const;

 private:
  friend Packing read_frame(const std::filesystem::path& path);
  struct State;
  explicit RunFile(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace jam
