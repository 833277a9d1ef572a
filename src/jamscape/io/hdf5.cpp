#include "jamscape/io/hdf5.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "jamscape/base/error.hpp"

namespace jam::hdf5 {
namespace {

std::recursive_mutex& library_mutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

/// The deepest entry of the library's error stack says what really went wrong.
std::string reason() {
  std::string text;
  H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_UPWARD,
      [](unsigned, const H5E_error2_t* entry, void* out) -> herr_t {
        auto& found = *static_cast<std::string*>(out);
        if (found.empty() && entry->desc) found = entry->desc;
        return 0;
      },
      &text);
  H5Eclear2(H5E_DEFAULT);
  if (const auto at = text.find("error message = '"); at != std::string::npos) {  // keep the system's sentence only
    const auto first = at + 17, last = text.find('\'', first);
    return text.substr(first, last == std::string::npos ? last : last - first);
  }
  return text.empty() ? "the HDF5 library gave no reason" : text;
}

[[noreturn]] void fail(const std::string& file, const std::string& wanted) {
  throw data_error(fmt::format("cannot {}: {}", wanted, reason()), file);
}

template <class Result>
Result check(Result result, const std::string& file, const std::string& wanted) {
  if (result < 0) fail(file, wanted);
  return result;
}

Handle property_list(hid_t kind) {
  Handle list(H5Pcreate(kind), H5Pclose);
  if (kind != H5P_FILE_ACCESS) H5Pset_obj_track_times(list.id(), false);
  return list;
}

/// The oldest format in which every piece of metadata carries a checksum, so that damage is noticed rather than read.
Handle file_access() {
  Handle list = property_list(H5P_FILE_ACCESS);
  H5Pset_libver_bounds(list.id(), H5F_LIBVER_V110, H5F_LIBVER_LATEST);
  H5Pset_file_locking(list.id(), false, true);  // locks fail on some network file systems and guard nothing here
  return list;
}

/// UTF-8 text of `size` bytes, or H5T_VARIABLE.
Handle string_type(std::size_t size) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), size);
  H5Tset_strpad(type.id(), size == H5T_VARIABLE ? H5T_STR_NULLTERM : H5T_STR_NULLPAD);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

Handle space_of(const Shape& shape) {
  return shape.empty() ? Handle(H5Screate(H5S_SCALAR), H5Sclose)
                       : Handle(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
}

Shape shape_of(hid_t space) {
  Shape shape(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space))));
  if (!shape.empty()) H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  return shape;
}

/// Number of elements; saturates, so that a hostile shape cannot wrap around to a small number.
hsize_t elements(const Shape& shape) {
  hsize_t n = 1;
  for (hsize_t s : shape)
    if (__builtin_mul_overflow(n, s, &n)) return ~hsize_t{0};
  return n;
}

/// The filters of a compressed array. Level 1: forces and positions hardly compress, a higher level only costs time.
Handle compressed(const Shape& chunk) {
  Handle list = property_list(H5P_DATASET_CREATE);
  H5Pset_chunk(list.id(), static_cast<int>(chunk.size()), chunk.data());
  H5Pset_shuffle(list.id());
  H5Pset_deflate(list.id(), 1);
  H5Pset_fletcher32(list.id());
  return list;
}

/// Chunks of about 64 KiB: first the leading axes are cut.
Shape chunk_of(Shape shape, std::size_t element) {
  for (std::size_t axis = 0; axis < shape.size(); ++axis) {
    const hsize_t row = elements(Shape(shape.begin() + static_cast<std::ptrdiff_t>(axis) + 1, shape.end())) * element;
    shape[axis] = std::clamp<hsize_t>(65536 / std::max<hsize_t>(row, 1), 1, shape[axis]);
    if (row <= 65536) break;
  }
  return shape;
}

/// Deflate packs at most 1032 to 1, so an array that claims more than that was never written.
void check_stored(hid_t dataset, hsize_t bytes, const std::string& file, const std::string& wanted) {
  const hsize_t stored = H5Dget_storage_size(dataset);
  if (bytes > 65536 && bytes / 2048 > stored)
    throw data_error(fmt::format("cannot {}: it claims {} bytes but holds {}", wanted, bytes, stored), file,
                     "the file is damaged; make it anew");
}

/// Strings of fixed length one behind the other, and back.
std::string pack(const std::vector<std::string>& values, std::size_t size) {
  std::string packed(values.size() * size, '\0');
  for (std::size_t k = 0; k < values.size(); ++k) values[k].copy(packed.data() + k * size, size);
  return packed;
}

std::vector<std::string> unpack(const std::string& packed, std::size_t size) {
  std::vector<std::string> values;
  for (std::size_t at = 0; at < packed.size(); at += size) {
    const std::string_view text(packed.data() + at, size);
    values.emplace_back(text.substr(0, text.find('\0')));
  }
  return values;
}

struct Names {
  std::vector<std::string> list;
  static herr_t link(hid_t, const char* name, const H5L_info_t*, void* out) {
    static_cast<Names*>(out)->list.emplace_back(name);
    return 0;
  }
  static herr_t attribute(hid_t, const char* name, const H5A_info_t*, void* out) {
    static_cast<Names*>(out)->list.emplace_back(name);
    return 0;
  }
};

}  // namespace

Lock::Lock() : lock_(library_mutex()) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // the error stack belongs to a thread, so each thread silences its own
}

bool Handle::reset() {
  if (id_ < 0) return true;
  const Lock lock;
  const bool closed = close_(id_) >= 0;
  id_ = -1;
  return closed;
}

#define JAM_HDF5_TYPE(T, STORED, MEMORY) \
  template <>                            \
  hid_t stored_type<T>() {               \
    return STORED;                       \
  }                                      \
  template <>                            \
  hid_t memory_type<T>() {               \
    return MEMORY;                       \
  }
JAM_HDF5_TYPE(double, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE)
JAM_HDF5_TYPE(std::int8_t, H5T_STD_I8LE, H5T_NATIVE_INT8)
JAM_HDF5_TYPE(std::uint8_t, H5T_STD_U8LE, H5T_NATIVE_UINT8)
JAM_HDF5_TYPE(std::uint16_t, H5T_STD_U16LE, H5T_NATIVE_UINT16)
JAM_HDF5_TYPE(std::int32_t, H5T_STD_I32LE, H5T_NATIVE_INT32)
JAM_HDF5_TYPE(std::uint32_t, H5T_STD_U32LE, H5T_NATIVE_UINT32)
JAM_HDF5_TYPE(std::int64_t, H5T_STD_I64LE, H5T_NATIVE_INT64)
JAM_HDF5_TYPE(std::uint64_t, H5T_STD_U64LE, H5T_NATIVE_UINT64)
#undef JAM_HDF5_TYPE

// ---- Dataset

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

// ---- Group

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

// ---- File

namespace {

Handle create_in(Storage& storage, const std::string& name) {
  const Handle creation = property_list(H5P_FILE_CREATE), access = file_access();
  use_storage(access.id(), storage);
  Handle made(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose);
  check(made.id(), name, "create the file");
  return made;
}

Handle open_in(hid_t access, const std::string& name) {
  Handle opened(H5Fopen(name.c_str(), H5F_ACC_RDONLY, access), H5Fclose);
  check(opened.id(), name, "open it as an HDF5 file");
  return opened;
}

}  // namespace

File File::create(const std::filesystem::path& path) {
  const Lock lock;
  auto disk = std::make_unique<DiskStorage>(path);
  Handle made = create_in(*disk, path.string());
  File file(std::move(made), path.string(), nullptr, std::move(disk));
  file.check();
  return file;
}

File File::create_image(const std::string& name) {
  const Lock lock;
  auto memory = std::make_unique<MemoryStorage>();
  Handle made = create_in(*memory, name);
  return {std::move(made), name, std::move(memory), nullptr};
}

File File::open(const std::filesystem::path& path) {
  const Lock lock;
  return {open_in(file_access().id(), path.string()), path.string(), nullptr, nullptr};
}

File File::open_image(std::string image, const std::string& name) {
  const Lock lock;
  auto memory = std::make_unique<MemoryStorage>(std::move(image));
  const Handle access = file_access();
  use_storage(access.id(), *memory);
  Handle opened = open_in(access.id(), name);
  return {std::move(opened), name, std::move(memory), nullptr};
}

Group File::root() const {
  const Lock lock;
  Handle opened(H5Gopen2(handle_.id(), "/", H5P_DEFAULT), H5Gclose);
  jam::hdf5::check(opened.id(), name_, "open the root group");
  return {std::move(opened), name_, "/"};
}

void File::check() const {
  if (disk_ && disk_->failure() != 0)
    throw data_error(fmt::format("cannot write the file: {}", std::strerror(disk_->failure())), name_,
                     "make room on the disk, or write elsewhere");
}

void File::close() {
  const Lock lock;
  if (!handle_.reset()) fail(name_, "close the file");
  check();
}

std::string File::close_image() {
  const Lock lock;
  if (!handle_.reset()) fail(name_, "close the file");
  return memory_->take();
}

#define JAM_HDF5_INSTANCE(T)                                                                     \
  template void Dataset::write<T>(const Shape&, const Shape&, std::span<const T>);               \
  template std::vector<T> Dataset::read<T>(const Shape&, const Shape&) const;                    \
  template Dataset Group::create<T>(std::string_view, const Shape&, const Shape&, const Shape&); \
  template void Group::write<T>(std::string_view, std::span<const T>, Shape);                    \
  template void Group::attribute<T>(std::string_view, const std::vector<T>&);                    \
  template std::vector<T> Group::read_attribute<T>(std::string_view) const;
JAM_HDF5_INSTANCE(double)
JAM_HDF5_INSTANCE(std::int8_t)
JAM_HDF5_INSTANCE(std::uint8_t)
JAM_HDF5_INSTANCE(std::uint16_t)
JAM_HDF5_INSTANCE(std::int32_t)
JAM_HDF5_INSTANCE(std::uint32_t)
JAM_HDF5_INSTANCE(std::int64_t)
JAM_HDF5_INSTANCE(std::uint64_t)
#undef JAM_HDF5_INSTANCE

}  // namespace jam::hdf5
