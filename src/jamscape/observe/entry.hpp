// The shapes in which a measure enters the registry. The names of its columns stand in its entry only: the
// functions give values in the order of the columns.
#pragma once

#include <string>
#include <vector>

#include "jamscape/observe/measure.hpp"

namespace jam {

/// What a person wants to know about a measure.
struct MeasureText {
  std::string name, title, formula, source;
};

/// One row a frame: a number per column; missing (NaN) where the packing lacks what the measure needs.
Measure frame_measure(MeasureText text, std::vector<ColumnInfo> columns,
                      std::function<std::vector<double>(const Snapshot&)> values, Needs needs = {});

/// One row a frame of numbers that take their time (fits, resampling): evaluated only where rows_measure is, all
/// columns missing (NaN) elsewhere.
Measure seldom_measure(MeasureText text, std::vector<ColumnInfo> columns,
                       std::function<std::vector<double>(const Snapshot&)> values);

/// Several rows a frame: a vector per column, the `abscissae` leading ones name the row. Evaluated only where the
/// packing fraction is a multiple of MeasureOptions::rows_every; a table without rows otherwise. Packings of clusters,
/// a few a run, pressed to no packing fraction in particular, always have their rows.
Measure rows_measure(MeasureText text, std::vector<ColumnInfo> columns, int abscissae, bool averaged,
                     std::function<std::vector<std::vector<double>>(const Snapshot&)> values);

/// Is the packing fraction a multiple of `every`, to within a hundredth of it (frames are taken at the first step that
/// reaches a packing fraction)? Always so for every = 0, and for a packing whose fraction is unknown (0).
bool is_multiple(double packing_fraction, double every);

}  // namespace jam
