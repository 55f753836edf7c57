// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include "model.hpp"

#include <clang/AST/Decl.h>
#include <clang/Frontend/ASTUnit.h>

#include <map>
#include <memory>
#include <set>
#include <string>

namespace pelage::codegen {

/// The headers of one translation unit, each with what its mirror holds.
class headers {
 public:
  /// `library`: the headers of pelage/ are what is written, not what is there already.
  headers(clang::ASTUnit& ast, bool library);

  /// The unit of a header of ours or of the translation unit's own file, or null for the rest of the world.
  unit* unit_of(clang::FileID file);

  /// True for what stands in the translation unit's own file or in a header that it includes itself.
  bool is_named(const clang::Decl* d);

  /// Notes what stands above a namespace, or by itself at its beginning: it tells about the whole header.
  void note_doc(const clang::NamespaceDecl* space);

  /// The units that something was written to.
  [[nodiscard]] std::vector<const unit*> written() const;

 private:
  clang::ASTUnit& ast_;
  clang::SourceManager& sources_;
  bool library_;
  std::set<const clang::FileEntry*> named_;  ///< included by the translation unit's own file
  std::map<const clang::FileEntry*, std::unique_ptr<unit>> units_;
};

}  // namespace pelage::codegen
