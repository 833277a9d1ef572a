// A measure is a pure function of a packing, registered once: name, formula, unit, source, and the columns it gives.
// Study files, --help, documentation, CSV headers and the report read that one entry.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "jamscape/base/table.hpp"
#include "jamscape/observe/options.hpp"
#include "jamscape/observe/snapshot.hpp"

namespace jam {

/// How often a measure's rows occur, and in which table they stand.
enum class Rows {
  frame,  ///< one row a frame: the columns join the table `frames`
  many,   ///< several rows a frame (bins, thresholds, points): a table of its own, named after the measure; no rows of
          ///< discs and spheres at packing fractions that are not multiples of MeasureOptions::rows_every
};

/// How realisations of one state are averaged. A missing value (NaN) never counts.
enum class Averaging {
  mean,                ///< mean over the realisations
  nonzero_or_missing,  ///< mean over those with a non-zero value; missing when fewer than half have one (S2: N_per/N)
  nonzero_or_zero,     ///< 0 when at least half are 0, else the mean over the non-zero ones (S2: S_p)
};

struct ColumnInfo {
  std::string name;  ///< as in CSV headers, snake_case
  std::string unit;  ///< "" where it has none
  std::string text;  ///< one sentence
  Averaging averaging = Averaging::mean;
};

/// A quantity of the ensemble that is a ratio of sums over its realisations, sum(over)/sum(under), and not the mean of
/// their ratios; its error by jackknife over the realisations. Missing where sum(under) is 0.
struct PooledRatio {
  std::string name;   ///< column of the ensemble's table
  std::string over;   ///< column of the measure
  std::string under;  ///< column of the measure
  std::string text;   ///< one sentence
};

/// What a packing must know, or be, for a measure to mean anything.
struct Needs {
  std::vector<bool Knowledge::*> known = {};
  bool upright_walls = false;  ///< walls only in upright cells
};

struct Measure {
  std::string name;     ///< snake_case; the key in study files
  std::string title;    ///< a few words
  std::string formula;  ///< plain text or TeX-like, with the usual misunderstanding where there is one
  std::string source;   ///< key of docs/references.bib, or paper and place
  Rows rows = Rows::frame;
  std::vector<ColumnInfo> columns;  ///< for Rows::many the abscissae come first
  int abscissae = 0;                ///< Rows::many: how many leading columns name the row (bin centre, threshold, ...)
  bool averaged = true;             ///< false: rows are points, not bins; no ensemble mean is taken (diagrams)
  std::function<Table(const Snapshot&)> evaluate;
  std::vector<PooledRatio> ratios = {};
  Needs needs = {};
};

/// Why a measure means nothing on a packing ("velocities are not given"); empty where it does. Its columns are missing
/// there, or it has no rows.
std::string lacking(const Needs& needs, const Packing& packing);

/// All measures, in the order of the documentation.
const std::vector<Measure>& measures();

/// Throws a usage error with the nearest known name.
const Measure& find_measure(std::string_view name);

}  // namespace jam
