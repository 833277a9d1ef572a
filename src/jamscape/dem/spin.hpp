// The spin of a body, and the surface velocity it brings to a contact.
#pragma once

#include "jamscape/contact/law.hpp"
#include "jamscape/dem/rows.hpp"

namespace jam {

/// Of the body whose row this is.
template <int D>
Axial<D> spin_of(const double* row) {
  if constexpr (D == 2)
    return row[Row<D>::spin];
  else
    return {row[Row<D>::spin], row[Row<D>::spin + 1], row[Row<D>::spin + 2]};
}
template <int D>
Axial<D> levered_spin(const double* row, double lever) {
  return lever * spin_of<D>(row);
}

}  // namespace jam
