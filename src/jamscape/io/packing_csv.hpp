// Packings as two CSV tables, one of particles and one of contacts: what experiments and spreadsheets have.
//
// Particles: id, x, y[, z], radius (or diameter), and optionally species, mass, vx, vy[, vz], spin, angle (3D: spin_x,
// ...). Contacts: id1, id2 and fn (or fx, fy[, fz], the force on id1), and optionally ft (2D: along the normal turned
// left) or ftx, fty[, ftz], nx, ny[, nz] (from id1 to id2), x, y[, z] (the point), overlap, sx, sy[, sz] (the copy of
// id2 that touches), part1, part2, sliding. id2 = -1 - w is wall w. Capitals do not matter; usual other names are
// known; columns not named here are named in the notes. Of several frames (a column frame, timestep, step, snapshot or
// time) one is asked for. Leading `# key: value` lines may give dimension, step, time, stage,
// packing_fraction, packing_fraction_plain, lo, hi, periodic, energy_... (particles) and wall (contacts: three numbers
// each for a point of a plane, its normal into the domain, its velocity; a cylinder has its axis as normal, and its
// radius as a tenth number; `# roles: side floor lid` says what each is for, and without it the last plane is the lid).
// Clusters have lines `# shape: ...` and columns shape, scale, qw, qx, qy, qz
// (cluster_columns.hpp), and their contacts need overlap, normal and point. What is missing is worked out from the rest
// where that can be done, and said in the notes; what contradicts itself is refused (packing_check.hpp).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "jamscape/io/csv.hpp"
#include "jamscape/packing/packing.hpp"

namespace jam {

struct ImportedPacking {
  Packing packing;
  std::vector<std::string> notes;  ///< what was assumed or left out, one sentence each, for the person who asked
};

/// Rows may stand in any order. A contact given from both sides (photoelastic solvers do) becomes one, the mean of
/// both. Throws a data error with the line for a missing column (naming the nearest there is), a grain given twice or
/// not at all, a contact given twice from the same side, and what is no number.
ImportedPacking read_packing_csv(const std::filesystem::path& particles, const std::filesystem::path& contacts);

/// The same of tables that are read already; of several frames the one named.
ImportedPacking read_packing(CsvFile particles, CsvFile contacts, std::optional<double> frame);

/// Numbers round-trip to the bit; rows of beads are written as planes.
void write_packing_csv(const Packing& packing, const std::filesystem::path& particles,
                       const std::filesystem::path& contacts);

}  // namespace jam
