// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "translator.hpp"

#include <iostream>

namespace pelage::codegen {

void problems::add(clang::SourceLocation where, const std::string& reason) {
  const clang::PresumedLoc place = sources_.getPresumedLoc(sources_.getExpansionLoc(where));
  found_.emplace(place.isValid() ? place.getFilename() : "?", place.isValid() ? place.getLine() : 0, reason);
}

bool problems::report() const {
  for (const auto& [file, line, reason] : found_)
    std::cerr << file << ":" << line << ": error: " << reason << "\n";
  return !found_.empty();
}

void translator::check_recursion() {
  std::map<const entity*, int> state;  // 1 while on the path, 2 when done
  const std::function<void(const entity*)> visit = [&](const entity* e) {
    state[e] = 1;
    for (const auto& [needed, where] : e->needs) {
      if (needed->is_function() && state[needed] == 1) {
        reject(where, "recursion: " + needed->name + " calls itself, directly or through others");
      } else if (state[needed] == 0) {
        visit(needed);
      }
    }
    state[e] = 2;
  };
  for (const auto& [decl, e] : entities_) {
    if (state[e.get()] == 0) visit(e.get());
  }
}

/// Types that C++ tells apart may be one in GLSL, and storage is none at all.
void translator::check_overloads() {
  std::set<std::string> seen;
  for (const auto& [decl, e] : entities_) {
    const bool ours = e->where != nullptr && !e->where->mirrored;
    if (ours && !seen.insert(e->is_function() ? e->signature : e->name).second) {
      reject(e->location, "`" + e->name + "` stands for two things in GLSL");
    }
  }
}

void translator::check_sizes() {
  for (const auto& [name, seen] : sizes_seen_) {
    if (seen.size() < 2) {
      reject(seen.begin()->second,
             name + " is instantiated at one size only: instantiate it at another one, too, to show that none is lost");
    }
  }
}

/// What names a size, and what needs that.
void translator::mark_sized() {
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [decl, e] : entities_) {
      const bool sized = !e->sizes.empty() || llvm::any_of(e->needs, [](const auto& n) { return n.first->sized; });
      changed = changed || sized != e->sized;
      e->sized = sized;
    }
  }
}

}  // namespace pelage::codegen
