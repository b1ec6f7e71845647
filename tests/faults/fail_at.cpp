// SPDX-License-Identifier: MIT
// A library to be loaded before all others (LD_PRELOAD): the n-th call of a kind fails, or ends the
// program as a power cut would.
//   CAMLAW_FAIL=files|memory     which calls are counted: those that change files, or allocations
//   CAMLAW_FAIL_AT=N             the one that fails, from 1; 0: none
//   CAMLAW_FAIL_AS=kill|EIO|ENOSPC   for files: killed before the call, or the call fails with that
//   CAMLAW_FAIL_COUNT=PATH       how many there were is written there at the program's end
#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

enum class Kind { None, Files, Memory };

struct Settings {
  Kind kind = Kind::None;
  long at = 0;
  int error = 0;  ///< 0: killed
  const char* count = nullptr;
};

Settings read_settings() {
  Settings s;
  const char* kind = std::getenv("CAMLAW_FAIL");
  if (kind == nullptr) return s;
  s.kind = std::strcmp(kind, "memory") == 0 ? Kind::Memory : Kind::Files;
  if (const char* at = std::getenv("CAMLAW_FAIL_AT")) s.at = std::strtol(at, nullptr, 10);
  if (const char* as = std::getenv("CAMLAW_FAIL_AS")) {
    s.error = std::strcmp(as, "EIO") == 0 ? EIO : std::strcmp(as, "ENOSPC") == 0 ? ENOSPC : 0;
  }
  s.count = std::getenv("CAMLAW_FAIL_COUNT");
  return s;
}

// Set by a constructor, so that what is allocated before main counts as well and nothing recurses.
Settings settings;
std::atomic<long> calls{0};

__attribute__((constructor)) void begin() { settings = read_settings(); }

__attribute__((destructor)) void end() {
  if (settings.count == nullptr) return;
  const int file = ::open(settings.count, O_WRONLY | O_CREAT | O_APPEND, 0600);
  if (file < 0) return;
  char text[32];
  const int length = std::snprintf(text, sizeof text, "%ld\n", calls.load());
  const auto written = ::write(file, text, static_cast<std::size_t>(length));
  (void)written;
  ::close(file);
}

/// Whether this call is the one that fails; of a kill it does not come back.
bool fails(Kind kind) {
  if (settings.kind != kind) return false;
  if (++calls != settings.at) return false;
  if (kind == Kind::Memory) return true;
  if (settings.error == 0) ::kill(::getpid(), SIGKILL);
  errno = settings.error;
  return true;
}

template <class F>
F* next(const char* name) {
  void* found = dlsym(RTLD_NEXT, name);
  F* function = nullptr;
  std::memcpy(&function, &found, sizeof function);
  return function;
}

/// Standard streams are not files that could be damaged.
bool is_file(int descriptor) { return descriptor > STDERR_FILENO; }

}  // namespace

extern "C" {

ssize_t write(int d, const void* data, size_t n) {
  static auto* const real = next<ssize_t(int, const void*, size_t)>("write");
  return is_file(d) && fails(Kind::Files) ? -1 : real(d, data, n);
}

ssize_t pwrite(int d, const void* data, size_t n, off_t at) {
  static auto* const real = next<ssize_t(int, const void*, size_t, off_t)>("pwrite");
  return fails(Kind::Files) ? -1 : real(d, data, n, at);
}

ssize_t pwrite64(int d, const void* data, size_t n, off64_t at) {
  static auto* const real = next<ssize_t(int, const void*, size_t, off64_t)>("pwrite64");
  return fails(Kind::Files) ? -1 : real(d, data, n, at);
}

int fsync(int d) {
  static auto* const real = next<int(int)>("fsync");
  return fails(Kind::Files) ? -1 : real(d);
}

int fdatasync(int d) {
  static auto* const real = next<int(int)>("fdatasync");
  return fails(Kind::Files) ? -1 : real(d);
}

int ftruncate(int d, off_t length) {
  static auto* const real = next<int(int, off_t)>("ftruncate");
  return fails(Kind::Files) ? -1 : real(d, length);
}

int ftruncate64(int d, off64_t length) {
  static auto* const real = next<int(int, off64_t)>("ftruncate64");
  return fails(Kind::Files) ? -1 : real(d, length);
}

int unlink(const char* path) {
  static auto* const real = next<int(const char*)>("unlink");
  return fails(Kind::Files) ? -1 : real(path);
}

int rename(const char* from, const char* to) {
  static auto* const real = next<int(const char*, const char*)>("rename");
  return fails(Kind::Files) ? -1 : real(from, to);
}

int link(const char* from, const char* to) {
  static auto* const real = next<int(const char*, const char*)>("link");
  return fails(Kind::Files) ? -1 : real(from, to);
}

int open64(const char* path, int flags, ...) {
  static auto* const real = next<int(const char*, int, ...)>("open64");
  va_list list;
  va_start(list, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(list, mode_t) : 0;
  va_end(list);
  const bool changes = (flags & (O_CREAT | O_TRUNC)) != 0;
  return changes && fails(Kind::Files) ? -1 : real(path, flags, mode);
}

void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* old, size_t size);

void* malloc(size_t size) {
  if (fails(Kind::Memory)) {
    errno = ENOMEM;
    return nullptr;
  }
  return __libc_malloc(size);
}

void* calloc(size_t count, size_t size) {
  if (fails(Kind::Memory)) {
    errno = ENOMEM;
    return nullptr;
  }
  return __libc_calloc(count, size);
}

void* realloc(void* old, size_t size) {
  if (fails(Kind::Memory)) {
    errno = ENOMEM;
    return nullptr;
  }
  return __libc_realloc(old, size);
}

}  // extern "C"
