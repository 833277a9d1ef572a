#include <fmt/format.h>

#include <algorithm>

#include "jamscape/base/error.hpp"
#include "jamscape/io/hdf5.hpp"
#include "jamscape/io/hdf5_calls.hpp"

namespace jam::hdf5 {

std::string Group::full(std::string_view name) const {
  return fmt::format("{}{}{}", path_, path_ == "/" ? "" : "/", name);
}

Group Group::create_group(std::string_view name) {
  const Lock lock;
  const Handle creation = property_list(H5P_GROUP_CREATE);
  Handle made(H5Gcreate2(handle_.id(), std::string(name).c_str(), H5P_DEFAULT, creation.id(), H5P_DEFAULT), H5Gclose);
  check(made.id(), file_, fmt::format("make the group '{}'", full(name)));
  return {std::move(made), file_, full(name)};
}

Group Group::group(std::string_view name) const {
  const Lock lock;
  Handle opened(H5Gopen2(handle_.id(), std::string(name).c_str(), H5P_DEFAULT), H5Gclose);
  check(opened.id(), file_, fmt::format("open the group '{}'", full(name)));
  return {std::move(opened), file_, full(name)};
}

bool Group::has(std::string_view name) const {
  const Lock lock;
  const bool found = H5Lexists(handle_.id(), std::string(name).c_str(), H5P_DEFAULT) > 0;
  H5Eclear2(H5E_DEFAULT);
  return found;
}

bool Group::is_group(std::string_view name) const {
  const Lock lock;
  const Handle object(H5Oopen(handle_.id(), std::string(name).c_str(), H5P_DEFAULT), H5Oclose);
  check(object.id(), file_, fmt::format("open '{}'", full(name)));
  return H5Iget_type(object.id()) == H5I_GROUP;
}

std::vector<std::string> Group::names() const {
  const Lock lock;
  Names names;
  hsize_t position = 0;
  check(H5Literate(handle_.id(), H5_INDEX_NAME, H5_ITER_INC, &position, Names::link, &names), file_,
        fmt::format("list the group '{}'", path_));
  return names.list;
}

void Group::link(std::string_view name, const Group& from, std::string_view member) {
  const Lock lock;
  check(H5Lcreate_hard(from.handle_.id(), std::string(member).c_str(), handle_.id(), std::string(name).c_str(),
                       H5P_DEFAULT, H5P_DEFAULT),
        file_, fmt::format("link '{}'", full(name)));
}

template <class T>
Dataset Group::create(std::string_view name, const Shape& shape, const Shape& most, const Shape& chunk) {
  const Lock lock;
  const std::string wanted = fmt::format("make '{}'", full(name));
  const Handle space(check(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), most.data()), file_, wanted),
                     H5Sclose);
  const Handle creation = compressed(chunk);
  Handle made(H5Dcreate2(handle_.id(), std::string(name).c_str(), stored_type<T>(), space.id(), H5P_DEFAULT,
                         creation.id(), H5P_DEFAULT),
              H5Dclose);
  check(made.id(), file_, wanted);
  return {std::move(made), file_, full(name)};
}

Dataset Group::dataset(std::string_view name) const {
  const Lock lock;
  Handle opened(H5Dopen2(handle_.id(), std::string(name).c_str(), H5P_DEFAULT), H5Dclose);
  check(opened.id(), file_, fmt::format("open '{}'", full(name)));
  return {std::move(opened), file_, full(name)};
}

template <class T>
void Group::write(std::string_view name, std::span<const T> values, Shape shape) {
  const Lock lock;
  if (shape.empty()) shape = {values.size()};
  const std::string wanted = fmt::format("write '{}'", full(name));
  const Handle space = space_of(shape);
  const Handle creation =
      values.size_bytes() > 1024 ? compressed(chunk_of(shape, sizeof(T))) : property_list(H5P_DATASET_CREATE);
  const Handle made(H5Dcreate2(handle_.id(), std::string(name).c_str(), stored_type<T>(), space.id(), H5P_DEFAULT,
                               creation.id(), H5P_DEFAULT),
                    H5Dclose);
  check(made.id(), file_, wanted);
  if (!values.empty())
    check(H5Dwrite(made.id(), memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), file_, wanted);
}

void Group::write_strings(std::string_view name, const std::vector<std::string>& values) {
  write_text(name, values, {values.size()});
}

void Group::write_string(std::string_view name, const std::string& value) { write_text(name, {value}, {}); }

void Group::write_text(std::string_view name, const std::vector<std::string>& values, const Shape& shape) {
  const Lock lock;
  const std::string wanted = fmt::format("write '{}'", full(name));
  std::size_t size = 1;
  for (const std::string& value : values) size = std::max(size, value.size());
  const Handle type = string_type(size), space = space_of(shape);
  const Handle creation =
      !shape.empty() && !values.empty() ? compressed(chunk_of(shape, size)) : property_list(H5P_DATASET_CREATE);
  const Handle made(H5Dcreate2(handle_.id(), std::string(name).c_str(), type.id(), space.id(), H5P_DEFAULT,
                               creation.id(), H5P_DEFAULT),
                    H5Dclose);
  check(made.id(), file_, wanted);
  if (!values.empty())
    check(H5Dwrite(made.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, pack(values, size).data()), file_, wanted);
}

std::vector<std::string> Group::read_strings(std::string_view name) const {
  const Lock lock;
  const Dataset data = dataset(name);
  const hid_t id = data.handle_.id();
  const std::string wanted = fmt::format("read '{}'", full(name));
  const Handle type(check(H5Dget_type(id), file_, wanted), H5Tclose);
  if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) != 0)
    throw data_error(fmt::format("cannot {}: it holds no text of fixed length", wanted), file_);
  const std::size_t size = H5Tget_size(type.id());
  const hsize_t bytes = elements({elements(data.shape()), size});
  check_stored(id, bytes, file_, wanted);
  std::string packed(bytes, '\0');
  if (bytes > 0)
    check(H5Dread(id, string_type(size).id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, packed.data()), file_, wanted);
  return unpack(packed, size);
}

#define JAM_HDF5_INSTANCE(T)                                                                     \
  template Dataset Group::create<T>(std::string_view, const Shape&, const Shape&, const Shape&); \
  template void Group::write<T>(std::string_view, std::span<const T>, Shape);
JAM_HDF5_NUMBERS(JAM_HDF5_INSTANCE)
#undef JAM_HDF5_INSTANCE

}  // namespace jam::hdf5
