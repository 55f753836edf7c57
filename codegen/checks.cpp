// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "translator.hpp"

#include <algorithm>
#include <iostream>

namespace pelage::codegen {

void problems::add(clang::SourceLocation where, const std::string& reason) {
  const clang::PresumedLoc place = sources_.getPresumedLoc(sources_.getExpansionLoc(where));
  found_.emplace(place.isValid() ? place.getFilename() : "?", place.isValid() ? place.getLine() : 0, reason);
}

void problems::print() const {
  for (const auto& [file, line, reason] : found_) {
    std::cerr << file << ":" << line << ": error: " << reason << "\n";
  }
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
  std::vector<const entity*> in_order;  // so that the same call closes the circle every time
  for (const auto& [decl, e] : entities_)
    in_order.push_back(e.get());
  std::sort(in_order.begin(), in_order.end(), [](auto* a, auto* b) { return a->location < b->location; });
  for (const entity* e : in_order) {
    if (state[e] == 0) visit(e);
  }
}

/// Types that C++ tells apart may be one in GLSL, and storage is none at all.
void translator::check_overloads() {
  std::map<std::string, const entity*> seen;
  for (const auto& [decl, e] : entities_) {
    if (e->name.empty() || e->where == nullptr || e->where->mirrored) continue;
    const std::string key = e->is_function() ? e->signature : e->name;
    const auto [other, fresh] = seen.try_emplace(key, e.get());
    if (!fresh) {
      const entity* later = other->second->location < e->location ? e.get() : other->second;
      reject(later->location, "`" + e->name + "` stands for two things in GLSL");
    }
  }
}

void translator::check_sizes() {
  for (const auto& [name, values] : sizes_seen_) {
    if (values.size() < 2) {
      reject(size_places_[name], name + " is instantiated at one size only: a second one shows that none is lost");
    }
  }
}

void translator::mark_sized() {
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [decl, e] : entities_) {
      const bool sized = !e->sizes.empty() ||
                         std::any_of(e->needs.begin(), e->needs.end(), [](const auto& n) { return n.first->sized; });
      changed = changed || sized != e->sized;
      e->sized = sized;
    }
  }
}

}  // namespace pelage::codegen
