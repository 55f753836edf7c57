// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <cstdint>

namespace rejected {

struct base {
  int x;
};

struct derived : base {  // error: base class
  int y;
};

struct constructed {  // error: struct with a constructor or a destructor: only aggregates are in the subset
  explicit constructed(int a) noexcept : x(a) {}
  int x;
};

struct destroyed {  // error: struct with a constructor or a destructor: only aggregates are in the subset
  ~destroyed() {}
  int x;
};

struct dynamic {  // error: virtual function
  virtual int get() const noexcept { return x; }  // error: virtual function
  int x;
};

struct closed {
  int get() const noexcept { return x; }

 private:
  int x;  // error: member that is not public
};

struct narrow {
  std::uint32_t x : 4;  // error: bit-field
};

struct defaulted {
  int x = 1;  // error: member with a default value
};

struct bound {
  int& x;  // error: reference as a member
  int y;
};

union either {  // error: union
  int x;
  float y;
};

struct nothing {};  // error: struct without members

struct comparable {
  int x;
  bool operator==(const comparable&) const noexcept = default;
};

bool equal(comparable a, comparable b) noexcept {
  return a == b;  // error: operator overload: call a function instead
}

struct summed {
  int x;
};

summed operator+(summed a, summed b) noexcept {
  return summed{a.x + b.x};
}

}  // namespace rejected
