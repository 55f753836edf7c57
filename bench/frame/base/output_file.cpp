// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/base/output_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <system_error>

namespace pelage::frame {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, const std::string& fault) {
  throw std::runtime_error(printable(path) + ": " + fault);
}

/// The folders on the way to a path that are not there yet, outermost first.
std::vector<fs::path> missing_folders(const fs::path& path) {
  std::vector<fs::path> missing;
  for (fs::path p = path.parent_path(); !p.empty() && !fs::exists(p); p = p.parent_path())
    missing.push_back(p);
  std::reverse(missing.begin(), missing.end());
  return missing;
}

void write_bytes(const fs::path& path, const fs::path& name, std::span<const std::byte> bytes) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) fail(name, std::string("cannot be written: ") + std::strerror(errno));
  const bool written = bytes.empty() || std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  int reason = written ? 0 : errno;
  if (std::fclose(file) != 0 && reason == 0) reason = errno;
  if (reason != 0) fail(name, std::string("cannot be written: ") + std::strerror(reason));
}

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

  for (const fs::path& folder : missing_folders(path)) {
    if (fs::create_directory(folder, error)) folders_.push_back(folder);
    if (error) fail(path, "cannot be written: " + error.message());
  }
  const fs::path whole = fs::weakly_canonical(path, error);
  for (const file& other : files_) {
    if (fs::weakly_canonical(other.path, error) == whole) fail(path, "two results would have this name");
  }
  fs::path partial = path;
  partial += ".";
  partial += std::to_string(getpid());
  partial += ".partial";
  write_bytes(partial, path, {});
  files_.push_back({path, partial});
}

void output_files::write(const fs::path& path, std::span<const std::byte> bytes) {
  for (const file& f : files_) {
    if (f.path == path) return write_bytes(f.partial, path, bytes);
  }
  fail(path, "was not begun");
}

void output_files::commit() {
  for (const file& f : files_) {
    std::error_code error;
    fs::rename(f.partial, f.path, error);
    if (error) fail(f.path, "cannot be written: " + error.message());
  }
  files_.clear();
  folders_.clear();
}

output_files::~output_files() {
  std::error_code ignored;
  for (const file& f : files_)
    fs::remove(f.partial, ignored);
  for (auto folder = folders_.rbegin(); folder != folders_.rend(); ++folder)
    fs::remove(*folder, ignored);
}

void write_file(const fs::path& path, std::span<const std::byte> bytes) {
  output_files one;
  one.add(path);
  one.write(path, bytes);
  one.commit();
}

}  // namespace pelage::frame
