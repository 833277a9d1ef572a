#include "jamscape/io/hdf5_calls.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "jamscape/base/error.hpp"

namespace jam::hdf5 {
namespace {

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

}  // namespace

void fail(const std::string& file, const std::string& wanted) {
  throw data_error(fmt::format("cannot {}: {}", wanted, reason()), file);
}

Handle property_list(hid_t kind) {
  Handle list(H5Pcreate(kind), H5Pclose);
  if (kind != H5P_FILE_ACCESS) H5Pset_obj_track_times(list.id(), false);
  return list;
}

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

hsize_t elements(const Shape& shape) {
  hsize_t n = 1;
  for (hsize_t s : shape)
    if (__builtin_mul_overflow(n, s, &n)) return ~hsize_t{0};
  return n;
}

/// Level 1: forces and positions hardly compress, a higher level only costs time.
Handle compressed(const Shape& chunk) {
  Handle list = property_list(H5P_DATASET_CREATE);
  H5Pset_chunk(list.id(), static_cast<int>(chunk.size()), chunk.data());
  H5Pset_shuffle(list.id());
  H5Pset_deflate(list.id(), 1);
  H5Pset_fletcher32(list.id());
  return list;
}

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

}  // namespace jam::hdf5
