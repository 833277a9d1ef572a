// The cells that the points of a diagram name, as tables.
#pragma once

#include "jamscape/base/table.hpp"
#include "jamscape/io/network_file.hpp"
#include "jamscape/topology/persistence.hpp"

namespace jam::app {

/// One row a point. Cells: a vertex by its place among the vertices, a contact by its place among those of the network,
/// both from 0; a larger clique by its place among all of its dimension in the order in which they enter. Columns i, j:
/// the vertices of the contact that makes the point what it is: in dimension 0 the one that joins the component to an
/// older one (an essential component: its first vertex, and -1), in dimension 1 the one that closes the loop; -1 above.
Table diagram_table(const NamedGraph& network, const Diagram& diagram);

/// One row for each cell that occurs in the diagram: dimension, number, the force at which it enters, its vertices.
Table cell_table(const NamedGraph& network, const Diagram& diagram);

}  // namespace jam::app
