// SPDX-License-Identifier: MIT
#include "cli/replacing.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace camlaw::cli {
namespace {

namespace fs = std::filesystem;

/// A descriptor that is closed whatever happens.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }
  /// What was written late may fail here.
  int close() {
    const int result = ::close(number_);
    number_ = -1;
    return result;
  }

 private:
  int number_;
};

/// Repeats a call that a signal has interrupted.
template <class F>
auto repeated(const F& call) {
  auto result = call();
  while (result < 0 && errno == EINTR) result = call();
  return result;
}

void write_all(int descriptor, std::string_view rest, const fs::path& named) {
  while (!rest.empty()) {
    const ssize_t count = repeated([&] { return write(descriptor, rest.data(), rest.size()); });
    if (count < 0) fail_to_write(named, std::strerror(errno));
    rest.remove_prefix(static_cast<std::size_t>(count));
  }
}

/// Some file systems know no flushing (EINVAL, ENOTSUP): they are believed.
void flush(int descriptor, const fs::path& named) {
  if (repeated([&] { return fsync(descriptor); }) == 0 || errno == EINVAL || errno == ENOTSUP) {
    return;
  }
  fail_to_write(named, std::strerror(errno));
}

/// The permissions of the file that is replaced, or those that a new one gets.
mode_t permissions_of(const fs::path& target) {
  struct stat there {};
  constexpr mode_t kAll = 07777, kNew = 0666;
  if (stat(target.c_str(), &there) == 0) return there.st_mode & kAll;
  const mode_t mask = umask(0);
  umask(mask);
  return kNew & ~mask;
}

std::string name_beside(const fs::path& target) {
  return (target.parent_path() / ".camlaw-XXXXXX").string();
}

/// Renames are on the disk when their folder is; a folder that cannot be flushed is not a failure,
/// for the files are in place.
void flush_folder(const fs::path& folder) {
  const Descriptor opened(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.number() >= 0) fsync(opened.number());
}

void make_one(const fs::path& folder, const fs::path& wanted_for, std::vector<fs::path>& made) {
  std::error_code error;
  if (folder.empty() || fs::exists(folder, error)) return;
  make_one(folder.parent_path(), wanted_for, made);
  if (fs::create_directory(folder, error)) made.push_back(folder);
  if (error) fail_to_write(wanted_for, error.message());
}

void remove_folders(const std::vector<fs::path>& outermost_first) {
  std::error_code ignored;
  for (std::size_t i = outermost_first.size(); i-- > 0;) fs::remove(outermost_first[i], ignored);
}

/// Makes a folder with those above it; returns those that were not there, outermost first. Where
/// one cannot be made it throws std::runtime_error naming `wanted_for`, and makes none.
std::vector<fs::path> make_folders(const fs::path& folder, const fs::path& wanted_for) {
  std::vector<fs::path> made;
  try {
    make_one(folder, wanted_for, made);
  } catch (...) {
    remove_folders(made);
    throw;
  }
  return made;
}

}  // namespace

void fail_to_write(const fs::path& path, const std::string& reason) {
  throw std::runtime_error(fmt::format("cannot write '{}': {}", path.string(), reason));
}

Replacing::Replacing() {
  sigset_t ends;
  sigemptyset(&ends);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&ends, number);
  pthread_sigmask(SIG_BLOCK, &ends, &signals_);
}

Replacing::~Replacing() {
  std::error_code ignored;
  if (!done_) {
    for (const File& file : files_) {
      if (!file.in_place) fs::remove(file.fresh, ignored);
    }
    remove_folders(folders_);
  }
  for (const File& file : files_) {
    if (!file.old.empty()) fs::remove(file.old, ignored);
  }
  pthread_sigmask(SIG_SETMASK, &signals_, nullptr);
}

void Replacing::add(const fs::path& target, std::string_view content, const fs::path& named,
                    const Pieces& more) {
  for (const fs::path& folder : make_folders(target.parent_path(), named)) {
    folders_.push_back(folder);
  }
  std::string name = name_beside(target);
  Descriptor fresh(mkostemp(name.data(), O_CLOEXEC));
  if (fresh.number() < 0) fail_to_write(named, std::strerror(errno));
  files_.push_back({target, named, name, {}, false});
  const auto take = [&](std::string_view piece) {
    write_all(fresh.number(), piece, named);
    return true;
  };
  take(content);
  if (more) more(take);
  // Where a file system has no permissions, there are none to keep.
  if (fchmod(fresh.number(), permissions_of(target)) != 0 && errno != EPERM && errno != ENOTSUP) {
    fail_to_write(named, std::strerror(errno));
  }
  flush(fresh.number(), named);
  if (fresh.close() != 0) fail_to_write(named, std::strerror(errno));
}

/// A second name for what stands in a file's place, by which it can come back.
void Replacing::keep_old(File& file) {
  // The name is free at the first, unless another program makes such ones too.
  constexpr int kTries = 100;
  if (fs::is_directory(fs::symlink_status(file.target))) {
    fail_to_write(file.named, "it is a folder");
  }
  for (int i = 0; i < kTries; ++i) {
    std::string name = name_beside(file.target);
    const Descriptor reserved(mkostemp(name.data(), O_CLOEXEC));
    if (reserved.number() < 0) fail_to_write(file.named, std::strerror(errno));
    unlink(name.c_str());
    if (link(file.target.c_str(), name.c_str()) == 0) {
      file.old = name;
      return;
    }
    if (errno == ENOENT) return;  // there is none
    if (errno != EEXIST) break;
  }
  // A file system without second names: then the old file goes by another one until the new one
  // stands.
  std::string name = name_beside(file.target);
  const Descriptor reserved(mkostemp(name.data(), O_CLOEXEC));
  if (reserved.number() < 0) fail_to_write(file.named, std::strerror(errno));
  if (rename(file.target.c_str(), name.c_str()) != 0) {
    const int reason = errno;
    unlink(name.c_str());
    fail_to_write(file.named, std::strerror(reason));
  }
  file.old = name;
}

void Replacing::put_back() {
  std::error_code ignored;
  for (File& file : files_) {
    if (!file.old.empty()) {
      fs::rename(file.old, file.target, ignored);
      fs::remove(file.old, ignored);  // where both are names of one file a rename does nothing
      file.old.clear();
    } else if (file.in_place) {
      fs::remove(file.target, ignored);
    }
  }
}

void Replacing::commit() {
  try {
    for (File& file : files_) {
      if (files_.size() > 1) keep_old(file);
      if (rename(file.fresh.c_str(), file.target.c_str()) != 0) {
        fail_to_write(file.named, std::strerror(errno));
      }
      file.in_place = true;
    }
  } catch (...) {
    put_back();
    throw;
  }
  for (const File& file : files_) flush_folder(file.target.parent_path());
  done_ = true;
}

}  // namespace camlaw::cli
