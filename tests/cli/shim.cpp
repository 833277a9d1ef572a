// A file system that can do less, put before the system's own by LD_PRELOAD: calls fail with the numbers in
// SHIM_FLOCK, SHIM_FSYNC, and SHIM_WRITE (to regular files, once SHIM_AFTER bytes are written).
#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>

namespace {

int code(const char* name) {
  const char* value = std::getenv(name);
  return value ? std::atoi(value) : 0;
}

int refuse(int number) {
  errno = number;
  return -1;
}

template <class Call>
Call* next(const char* name) {
  return reinterpret_cast<Call*>(dlsym(RTLD_NEXT, name));
}

int full(int file, std::size_t size) {
  static std::atomic<long> written{0};
  const int number = code("SHIM_WRITE");
  struct stat facts {};
  if (number == 0 || fstat(file, &facts) != 0 || !S_ISREG(facts.st_mode)) return 0;
  return (written += static_cast<long>(size)) > code("SHIM_AFTER") ? number : 0;
}

}  // namespace

extern "C" {

int flock(int file, int operation) {
  if (const int number = code("SHIM_FLOCK")) return refuse(number);
  return next<int(int, int)>("flock")(file, operation);
}

int fsync(int file) {
  if (const int number = code("SHIM_FSYNC")) return refuse(number);
  return next<int(int)>("fsync")(file);
}

ssize_t write(int file, const void* bytes, size_t size) {
  if (const int number = full(file, size)) return refuse(number);
  return next<ssize_t(int, const void*, size_t)>("write")(file, bytes, size);
}

ssize_t pwrite(int file, const void* bytes, size_t size, off_t at) {
  if (const int number = full(file, size)) return refuse(number);
  return next<ssize_t(int, const void*, size_t, off_t)>("pwrite")(file, bytes, size, at);
}

ssize_t pwrite64(int file, const void* bytes, size_t size, off64_t at) {
  if (const int number = full(file, size)) return refuse(number);
  return next<ssize_t(int, const void*, size_t, off64_t)>("pwrite64")(file, bytes, size, at);
}

}  // extern "C"
