#include <fmt/format.h>

#include <algorithm>

#include "jamscape/base/error.hpp"
#include "jamscape/io/hdf5.hpp"
#include "jamscape/io/hdf5_calls.hpp"

namespace jam::hdf5 {

template <class T>
void Group::attribute(std::string_view name, const std::vector<T>& values) {
  const Lock lock;
  write_attribute(name, Handle(H5Tcopy(stored_type<T>()), H5Tclose),
                  values.size() == 1 ? Shape{} : Shape{values.size()}, values.data());
}

void Group::attribute(std::string_view name, const std::string& value) {
  const Lock lock;
  const std::size_t size = std::max<std::size_t>(value.size(), 1);
  write_attribute(name, string_type(size), {}, pack({value}, size).data());
}

void Group::attribute_for_others(std::string_view name, const std::vector<std::string>& values) {
  const Lock lock;
  std::vector<const char*> raw;
  for (const std::string& value : values) raw.push_back(value.c_str());
  write_attribute(name, string_type(H5T_VARIABLE), values.size() == 1 ? Shape{} : Shape{values.size()}, raw.data());
}

void Group::write_attribute(std::string_view name, const Handle& type, const Shape& shape, const void* values) {
  const std::string wanted = fmt::format("write the attribute '{}' of '{}'", name, path_);
  const Handle space = space_of(shape);
  const Handle made(
      H5Acreate2(handle_.id(), std::string(name).c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  check(made.id(), file_, wanted);
  check(H5Awrite(made.id(), type.id(), values), file_, wanted);
}

bool Group::has_attribute(std::string_view name) const {
  const Lock lock;
  return H5Aexists(handle_.id(), std::string(name).c_str()) > 0;
}

template <class T>
std::vector<T> Group::read_attribute(std::string_view name) const {
  const Lock lock;
  const std::string wanted = fmt::format("read the attribute '{}' of '{}'", name, path_);
  const Handle opened(H5Aopen(handle_.id(), std::string(name).c_str(), H5P_DEFAULT), H5Aclose);
  check(opened.id(), file_, wanted);
  const Handle space(H5Aget_space(opened.id()), H5Sclose);
  const hsize_t n = elements(shape_of(space.id()));
  if (n > 65536) throw data_error(fmt::format("cannot {}: {} values are too many", wanted, n), file_);
  std::vector<T> values(n);
  if (n > 0) check(H5Aread(opened.id(), memory_type<T>(), values.data()), file_, wanted);
  return values;
}

std::optional<std::string> Group::read_text_attribute(std::string_view name) const {
  const Lock lock;
  const std::string wanted = fmt::format("read the attribute '{}' of '{}'", name, path_);
  const Handle opened(H5Aopen(handle_.id(), std::string(name).c_str(), H5P_DEFAULT), H5Aclose);
  check(opened.id(), file_, wanted);
  const Handle type(H5Aget_type(opened.id()), H5Tclose), space(H5Aget_space(opened.id()), H5Sclose);
  if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) != 0 ||
      H5Sget_simple_extent_type(space.id()) != H5S_SCALAR)
    return {};
  const std::size_t size = H5Tget_size(type.id());
  std::string packed(size, '\0');
  check(H5Aread(opened.id(), string_type(size).id(), packed.data()), file_, wanted);
  return unpack(packed, size)[0];
}

std::vector<std::string> Group::attribute_names() const {
  const Lock lock;
  Names names;
  hsize_t position = 0;
  check(H5Aiterate2(handle_.id(), H5_INDEX_NAME, H5_ITER_INC, &position, Names::attribute, &names), file_,
        fmt::format("list the attributes of '{}'", path_));
  return names.list;
}

#define JAM_HDF5_INSTANCE(T)                                                  \
  template void Group::attribute<T>(std::string_view, const std::vector<T>&); \
  template std::vector<T> Group::read_attribute<T>(std::string_view) const;
JAM_HDF5_NUMBERS(JAM_HDF5_INSTANCE)
#undef JAM_HDF5_INSTANCE

}  // namespace jam::hdf5
