#include <fmt/format.h>

#include "jamscape/base/error.hpp"
#include "jamscape/io/hdf5.hpp"
#include "jamscape/io/hdf5_calls.hpp"

namespace jam::hdf5 {

Shape Dataset::shape() const {
  const Lock lock;
  const Handle space(check(H5Dget_space(handle_.id()), file_, fmt::format("read the shape of '{}'", path_)), H5Sclose);
  return shape_of(space.id());
}

Kind Dataset::kind() const {
  const Lock lock;
  const Handle type(check(H5Dget_type(handle_.id()), file_, fmt::format("read the type of '{}'", path_)), H5Tclose);
  switch (H5Tget_class(type.id())) {
    case H5T_FLOAT:
      return Kind::real;
    case H5T_INTEGER:
      return H5Tequal(type.id(), H5T_STD_U8LE) > 0 ? Kind::byte : Kind::integer;
    default:
      return Kind::other;
  }
}

void Dataset::resize(const Shape& shape) {
  const Lock lock;
  check(H5Dset_extent(handle_.id(), shape.data()), file_, fmt::format("enlarge '{}'", path_));
}

template <class T>
void Dataset::write(const Shape& start, const Shape& count, std::span<const T> values) {
  if (values.empty()) return;
  const Lock lock;
  const std::string wanted = fmt::format("write '{}'", path_);
  const Handle file_space(check(H5Dget_space(handle_.id()), file_, wanted), H5Sclose);
  const Handle memory_space = space_of(count);
  if (!count.empty())
    check(H5Sselect_hyperslab(file_space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr), file_,
          wanted);
  check(H5Dwrite(handle_.id(), memory_type<T>(), memory_space.id(), file_space.id(), H5P_DEFAULT, values.data()), file_,
        wanted);
}

template <class T>
std::vector<T> Dataset::read(const Shape& start, const Shape& count) const {
  const Lock lock;
  const std::string wanted = fmt::format("read '{}'", path_);
  const hsize_t n = elements(count);
  check_stored(handle_.id(), elements({n, sizeof(T)}), file_, wanted);
  const Handle type(check(H5Dget_type(handle_.id()), file_, wanted), H5Tclose);
  if (const auto kind = H5Tget_class(type.id()); kind != H5T_INTEGER && kind != H5T_FLOAT && kind != H5T_ENUM)
    throw data_error(fmt::format("cannot {}: it holds no numbers", wanted), file_);
  std::vector<T> values(n);
  if (n == 0) return values;
  const Handle file_space(check(H5Dget_space(handle_.id()), file_, wanted), H5Sclose);
  const Shape whole = shape_of(file_space.id());
  if (whole.size() != count.size())
    throw data_error(fmt::format("cannot {}: it has {} axes instead of {}", wanted, whole.size(), count.size()), file_);
  for (std::size_t k = 0; k < whole.size(); ++k)
    if (start[k] > whole[k] || count[k] > whole[k] - start[k])
      throw data_error(fmt::format("cannot {}: {} entries from {} on axis {}, which has {}", wanted, count[k], start[k],
                                   k, whole[k]),
                       file_);
  const Handle memory_space = space_of(count);
  if (!count.empty())
    check(H5Sselect_hyperslab(file_space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr), file_,
          wanted);
  check(H5Dread(handle_.id(), memory_type<T>(), memory_space.id(), file_space.id(), H5P_DEFAULT, values.data()), file_,
        wanted);
  return values;
}

#define JAM_HDF5_INSTANCE(T)                                                       \
  template void Dataset::write<T>(const Shape&, const Shape&, std::span<const T>); \
  template std::vector<T> Dataset::read<T>(const Shape&, const Shape&) const;
JAM_HDF5_NUMBERS(JAM_HDF5_INSTANCE)
#undef JAM_HDF5_INSTANCE

}  // namespace jam::hdf5
