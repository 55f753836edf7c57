// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "translator.hpp"

namespace pelage::codegen {

using namespace clang;

std::string doc_lines_above(llvm::StringRef text, std::size_t offset) {
  std::size_t begin = text.rfind('\n', offset);
  std::string doc;
  while (begin != llvm::StringRef::npos && begin > 0) {
    const std::size_t previous = text.rfind('\n', begin);
    const std::size_t start = previous == llvm::StringRef::npos ? 0 : previous + 1;
    const llvm::StringRef above = text.slice(start, begin).trim();
    if (!above.startswith("///")) break;
    doc = above.str() + "\n" + doc;
    begin = previous;
  }
  return doc;
}

/// The /// lines right above a declaration.
std::string translator::doc_above(SourceLocation declaration) {
  return doc_lines_above(sources_.getBufferData(file(declaration)), offset(declaration));
}

/// The ///< comment behind a declaration, with lines that continue it.
std::string translator::doc_beside(SourceLocation declaration) {
  const llvm::StringRef text = sources_.getBufferData(file(declaration));
  std::string doc;
  for (std::size_t begin = offset(declaration);;) {
    const std::size_t end = text.find('\n', begin);
    const llvm::StringRef rest = text.slice(begin, end);
    const std::size_t comment = rest.find("///<");
    if (comment == llvm::StringRef::npos || (!doc.empty() && !rest.trim().startswith("///<"))) return doc;
    doc += (doc.empty() ? "" : "\n") + rest.substr(comment).rtrim().str();
    begin = end + 1;
  }
}

}  // namespace pelage::codegen
