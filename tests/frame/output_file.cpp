// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/base/output_file.hpp"

#include "frame/scratch_folder.hpp"
#include "property.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>

namespace pelage::test {

using namespace frame;
namespace fs = std::filesystem;

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST_CASE("files and their folders appear together in commit, and not before") {
  const scratch_folder folder;
  const fs::path deep = folder.path / "new" / "deep" / "a";
  const fs::path old = folder.path / "b";
  write_file(old, bytes_of("old"));
  output_files both;
  both.add(deep);
  both.add(old);
  both.write(deep, bytes_of("one"));
  both.write(old, bytes_of("two"));
  CHECK(!fs::exists(deep));
  CHECK(read(old) == "old");
  both.commit();
  CHECK(read(deep) == "one");
  CHECK(read(old) == "two");
  CHECK(folder.entries() == 2);
}

TEST_CASE("without commit nothing is left, and what was there is as it was") {
  const scratch_folder folder;
  const fs::path old = folder.path / "b";
  write_file(old, bytes_of("old"));
  {
    output_files both;
    both.add(folder.path / "new" / "deep" / "a");
    both.add(old);
    both.write(old, bytes_of("two"));
  }
  CHECK(read(old) == "old");
  CHECK(folder.entries() == 1);
}

TEST_CASE("a process that is killed before commit leaves nothing") {
  const scratch_folder folder;
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    output_files one;
    one.add(folder.path / "new" / "a");
    one.write(folder.path / "new" / "a", bytes_of("one"));
    kill(getpid(), SIGKILL);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(WIFSIGNALED(status));
  CHECK(folder.entries() == 0);
}

TEST_CASE("a commit that fails leaves nothing of its own") {
  const scratch_folder folder;
  const fs::path blocked = folder.path / "new" / "b";
  output_files both;
  both.add(folder.path / "new" / "a");
  both.add(blocked);
  fs::create_directories(blocked / "in the way");
  CHECK_THROWS_AS(both.commit(), std::runtime_error);
  fs::remove_all(blocked);
  CHECK(!fs::exists(folder.path / "new" / "b"));
  for (const auto& left : fs::directory_iterator(folder.path / "new"))
    CHECK(left.path().filename() == "a");
}

TEST_CASE("a path that cannot be a result is refused before anything is written") {
  const scratch_folder folder;
  const fs::path path = folder.path / "a";
  output_files files;
  files.add(path);
  CHECK_THROWS_AS(files.add(path), std::runtime_error);
  CHECK_THROWS_AS(files.add(folder.path / "." / "a"), std::runtime_error);
  CHECK_THROWS_AS(files.add(path / "b"), std::runtime_error);
  CHECK_THROWS_AS(files.add(""), std::runtime_error);
  CHECK_THROWS_WITH(files.add(folder.path / std::string(300, 'x') / "sub" / "y"),
                    doctest::Contains("cannot be written"));
  const fs::path relative = fs::relative(folder.path / "z");
  files.add(relative);
  CHECK_THROWS_AS(files.add("." / relative), std::runtime_error);
  CHECK_THROWS_AS(files.add(fs::absolute(relative)), std::runtime_error);
  files.add(folder.path / "q" / "y");
  CHECK_THROWS_AS(files.add(folder.path / "q"), std::runtime_error);
  CHECK_THROWS_AS(files.add(folder.path), std::runtime_error);
  CHECK_THROWS_AS(files.add(folder.path / "c" / ""), std::runtime_error);
  CHECK_THROWS_AS(files.write(folder.path / "b", {}), std::runtime_error);
}

}  // namespace pelage::test
