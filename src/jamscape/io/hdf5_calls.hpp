// What every call to the HDF5 library needs: errors with the library's own reason, property lists, shapes, text.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "jamscape/io/hdf5.hpp"

namespace jam::hdf5 {

/// Throws a data error: what was wanted of which file, and the library's reason.
[[noreturn]] void fail(const std::string& file, const std::string& wanted);

template <class Result>
Result check(Result result, const std::string& file, const std::string& wanted) {
  if (result < 0) fail(file, wanted);
  return result;
}

Handle property_list(hid_t kind);
/// The filters of a compressed array.
Handle compressed(const Shape& chunk);
/// Chunks of about 64 KiB: first the leading axes are cut.
Shape chunk_of(Shape shape, std::size_t element);

Handle space_of(const Shape& shape);
Shape shape_of(hid_t space);
/// Number of elements; saturates, so that a hostile shape cannot wrap around to a small number.
hsize_t elements(const Shape& shape);
/// Throws for an array that claims more bytes than its compressed ones could make.
void check_stored(hid_t dataset, hsize_t bytes, const std::string& file, const std::string& wanted);

/// UTF-8 text of `size` bytes, or H5T_VARIABLE.
Handle string_type(std::size_t size);
/// Strings of fixed length one behind the other, and back.
std::string pack(const std::vector<std::string>& values, std::size_t size);
std::vector<std::string> unpack(const std::string& packed, std::size_t size);

/// For the library's iterations over links and attributes: a call that adds each name to the `list` of its last
/// argument.
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

/// The number types of arrays and attributes, for X(T) once each.
#define JAM_HDF5_NUMBERS(X) \
  X(double)                 \
  X(std::int8_t)            \
  X(std::uint8_t)           \
  X(std::uint16_t)          \
  X(std::int32_t)           \
  X(std::uint32_t)          \
  X(std::int64_t)           \
  X(std::uint64_t)

}  // namespace jam::hdf5
