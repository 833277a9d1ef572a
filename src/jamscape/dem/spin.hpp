// The surface velocity a body's spin brings to a contact.
#pragma once

#include "jamscape/contact/law.hpp"
#include "jamscape/dem/rows.hpp"

namespace jam {

/// lever * angular velocity, of the body whose row this is.
template <int D>
Axial<D> levered_spin(const double* row, double lever) {
  if constexpr (D == 2)
    return lever * row[Row<D>::spin];
  else
    return {lever * row[Row<D>::spin], lever * row[Row<D>::spin + 1], lever * row[Row<D>::spin + 2]};
}

}  // namespace jam
