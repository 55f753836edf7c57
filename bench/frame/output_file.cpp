// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/output_file.hpp"

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

struct remove_unless_kept {
  const fs::path& path;
  bool kept = false;

  ~remove_unless_kept() {
    std::error_code ignored;
    if (!kept) fs::remove(path, ignored);
  }
};

}  // namespace

std::string printable(const fs::path& path) {
  std::string text = path.string();
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return text;
}

void write_file(const fs::path& path, std::span<const std::byte> bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) fail(path, "is not a regular file");

  fs::path partial = path;
  partial += ".partial";
  std::FILE* file = std::fopen(partial.c_str(), "wb");
  if (file == nullptr) fail(path, std::string("cannot be written: ") + std::strerror(errno));

  remove_unless_kept guard{partial};
  const bool written = bytes.empty() || std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  int reason = written ? 0 : errno;
  if (std::fclose(file) != 0 && reason == 0) reason = errno;
  if (reason != 0) fail(path, std::string("cannot be written: ") + std::strerror(reason));

  fs::rename(partial, path, error);
  if (error) fail(path, "cannot be written: " + error.message());
  guard.kept = true;
}

}  // namespace pelage::frame
