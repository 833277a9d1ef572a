#include "jamscape/io/hdf5.hpp"

namespace jam::hdf5 {
namespace {

std::recursive_mutex& library_mutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

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

}  // namespace jam::hdf5
