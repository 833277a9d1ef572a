// The shapes of clusters in a run file (run_file.hpp describes the layout), and what must hold of clusters before they
// are written or handed out.
#pragma once

#include <string>
#include <vector>

#include "jamscape/io/hdf5.hpp"
#include "jamscape/packing/packing.hpp"

namespace jam {

/// Fills a group with the shapes.
void write_shapes(hdf5::Group& group, const std::vector<ClusterShape>& shapes);

/// The shapes of a group. Throws a data error where its arrays do not fit together.
std::vector<ClusterShape> read_shapes(const hdf5::Group& group);

/// What is wrong with the shapes, with the grains that have them, with the parts that contacts name, or with cylinders;
/// empty when nothing is. In a packing without shapes no grain has one.
std::string cluster_problem(const Packing& packing);

}  // namespace jam
