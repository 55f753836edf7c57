// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "translator.hpp"

#include <clang/Lex/Lexer.h>

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

void translator::read_comments(const Stmt* body) {
  comments_.clear();
  next_comment_ = 0;
  const SourceLocation begin = sources_.getExpansionLoc(body->getBeginLoc());
  const unsigned last = offset(body->getEndLoc());
  const FileID file = sources_.getFileID(begin);
  const llvm::StringRef text = sources_.getBufferData(file);
  Lexer lexer(sources_.getLocForStartOfFile(file), context_.getLangOpts(), text.begin(), text.begin() + offset(begin),
              text.end());
  lexer.SetCommentRetentionState(true);
  for (Token token; !lexer.LexFromRawLexer(token) && offset(token.getLocation()) < last;) {
    if (!token.is(tok::comment)) continue;
    const unsigned at = offset(token.getLocation());
    const unsigned first_line = line(token.getLocation());
    const llvm::StringRef spelled = text.substr(at, token.getLength()).rtrim();
    const unsigned lines = static_cast<unsigned>(spelled.count('\n'));
    comments_.push_back({at, first_line, first_line + lines, spelled.str()});
  }
}

/// The comments between the last statement and the next one at `before`; `last_line` is where the last one ended.
std::string translator::comments_before(unsigned before, unsigned& last_line) {
  std::string text;
  for (; next_comment_ < comments_.size() && comments_[next_comment_].offset < before; ++next_comment_) {
    const comment& c = comments_[next_comment_];
    if (last_line != 0 && c.line > last_line + 1) text += "\n";
    text += c.text + "\n";
    last_line = c.last_line;
  }
  return text;
}

/// The comment behind a statement on its last line.
std::string translator::comment_beside(SourceLocation end) {
  while (next_comment_ < comments_.size() && comments_[next_comment_].offset < offset(end) &&
         comments_[next_comment_].line < line(end)) {
    ++next_comment_;  // inside an expression: there is no place for it
  }
  if (next_comment_ < comments_.size() && comments_[next_comment_].line == line(end)) {
    return "  " + comments_[next_comment_++].text;
  }
  return {};
}

}  // namespace pelage::codegen
