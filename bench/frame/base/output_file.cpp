// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/base/output_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <system_error>

namespace pelage::frame {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, const std::string& fault) {
  throw std::runtime_error(printable(path) + ": " + fault);
}

/// The same for all ways to write a path.
fs::path whole_path(const fs::path& path) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path), error);
  return error ? fs::absolute(path) : whole;
}

/// True where `path` begins with all parts of `folder`.
bool begins_with(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

/// A file beside the name that it is to have, gone again with the folders made for it unless it got the name.
class partial_file {
 public:
  explicit partial_file(const fs::path& path) : path_(path), partial_(path) {
    partial_ += "." + std::to_string(getpid()) + ".partial";
    std::vector<fs::path> missing;
    std::error_code error;
    for (fs::path p = path.parent_path(); !p.empty() && !fs::exists(p, error); p = p.parent_path())
      missing.push_back(p);
    error.clear();
    for (; !missing.empty() && !error; missing.pop_back()) {
      if (fs::create_directory(missing.back(), error)) folders_.push_back(missing.back());
    }
    if (error) refuse(error.message());
    write({});
  }
  partial_file(const partial_file&) = delete;
  partial_file& operator=(const partial_file&) = delete;
  ~partial_file() { remove(); }

  void write(std::span<const std::byte> bytes) {
    std::FILE* file = std::fopen(partial_.c_str(), "wb");
    if (file == nullptr) refuse(std::strerror(errno));
    const bool written = bytes.empty() || std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    int reason = written ? 0 : errno;
    if (std::fclose(file) != 0 && reason == 0) reason = errno;
    if (reason != 0) refuse(std::strerror(reason));
  }

  void take_name() {
    std::error_code error;
    fs::rename(partial_, path_, error);
    if (error) refuse(error.message());
    folders_.clear();
  }

 private:
  void remove() noexcept {
    std::error_code ignored;
    fs::remove(partial_, ignored);
    for (; !folders_.empty(); folders_.pop_back())
      fs::remove(folders_.back(), ignored);
  }

  [[noreturn]] void refuse(const std::string& reason) {
    remove();  // a constructor that throws has no destructor
    fail(path_, "cannot be written: " + reason);
  }

  fs::path path_, partial_;
  std::vector<fs::path> folders_;  ///< made for it, outermost first
};

/// While it lives the signals that ask a process to end do nothing.
class ignored_signals {
 public:
  ignored_signals() {
    for (std::size_t i = 0; i < std::size(signals); ++i)
      before_[i] = std::signal(signals[i], SIG_IGN);
  }
  ignored_signals(const ignored_signals&) = delete;
  ignored_signals& operator=(const ignored_signals&) = delete;
  ~ignored_signals() {
    for (std::size_t i = 0; i < std::size(signals); ++i)
      std::signal(signals[i], before_[i]);
  }

 private:
  static constexpr int signals[] = {SIGHUP, SIGINT, SIGTERM};
  void (*before_[std::size(signals)])(int);
};

}  // namespace

std::string printable(const fs::path& path) {
  std::string text = path.string();
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return text;
}

void output_files::add(const fs::path& path) {
  std::error_code error;
  if (!path.has_filename()) fail(path, "names no file");
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) fail(path, "is not a regular file");

  const fs::path whole = whole_path(path);
  for (const file& other : files_) {
    const fs::path one = whole_path(other.path);
    if (one == whole) fail(path, "two results would have this name");
    if (begins_with(one, whole) || begins_with(whole, one)) fail(path, "one result would be the folder of another");
  }
  const ignored_signals until_gone;
  const partial_file attempt(path);
  files_.push_back({path, {}});
}

void output_files::write(const fs::path& path, std::span<const std::byte> bytes) {
  for (file& f : files_) {
    if (f.path == path) return f.bytes.assign(bytes.begin(), bytes.end());
  }
  fail(path, "was not begun");
}

void output_files::commit() {
  const ignored_signals until_named;
  std::vector<std::unique_ptr<partial_file>> begun;
  try {
    for (const file& f : files_)
      begun.emplace_back(std::make_unique<partial_file>(f.path))->write(f.bytes);
    for (const auto& each : begun)
      each->take_name();
  } catch (...) {
    for (; !begun.empty(); begun.pop_back()) {  // the first made the folders of the later ones
    }
    throw;
  }
  files_.clear();
}

void write_file(const fs::path& path, std::span<const std::byte> bytes) {
  output_files one;
  one.add(path);
  one.write(path, bytes);
  one.commit();
}

}  // namespace pelage::frame
