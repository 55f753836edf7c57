// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The names in comments, as the reader of GLSL knows them.
#include "model.hpp"

#include <filesystem>

namespace pelage::codegen {

namespace {

/// Letters, digits, `_` and whatever is not ASCII.
bool is_of_word(char c) {
  return llvm::isAlnum(c) || c == '_' || static_cast<unsigned char>(c) >= 0x80u;
}

llvm::StringRef word_at(llvm::StringRef text) {
  return text.take_while(is_of_word);
}

/// How long `<K, 2 * N>` is, at the beginning of a text; 0 where there is none.
std::size_t arguments_length(llvm::StringRef text) {
  if (!text.startswith("<")) return 0;
  std::size_t depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '<') ++depth;
    if (c == '>' && --depth == 0) return i + 1;
    if (!is_of_word(c) && !llvm::StringRef("<> ,:*+").contains(c)) return 0;
  }
  return 0;
}

/// A name as C++ writes it: pelage::k_buffer<K>::insert.
struct written_name {
  std::string path;    ///< without template arguments
  std::size_t length;  ///< of the text
  bool qualified = false;
};

written_name name_at(llvm::StringRef text) {
  const llvm::StringRef first = word_at(text);
  written_name name = {first.str(), first.size()};
  for (;;) {
    const std::size_t arguments = arguments_length(text.substr(name.length));
    llvm::StringRef rest = text.substr(name.length + arguments);
    const llvm::StringRef member = rest.consume_front("::") ? word_at(rest) : llvm::StringRef();
    if (member.empty()) {
      name.length += arguments;
      return name;
    }
    name.path += "::" + member.str();
    name.length += arguments + 2 + member.size();
    name.qualified = true;
  }
}

}  // namespace

std::string glossary::name(const std::string& written, const std::string& scope) const {
  for (std::string place = scope + "::";;) {
    const auto found = names.find(place + written);
    if (found != names.end()) return found->second;
    if (place.empty()) return {};
    const std::size_t outer = llvm::StringRef(place).drop_back(2).rfind("::");
    place.resize(outer == llvm::StringRef::npos ? 0 : outer + 2);
  }
}

std::string glossary::file(llvm::StringRef written, const std::string& header) const {
  const std::string beside = (std::filesystem::path(header).parent_path() / written.str()).string();
  for (const std::string& one : {beside, "pelage/" + written.str(), written.str()}) {
    if (headers.count(one) == 0) continue;
    const bool whole = written.startswith("pelage/");
    return (whole ? "pelage/glsl/" : "") + written.drop_front(whole ? 7 : 0).drop_back(4).str() + ".glsl";
  }
  return written.str();
}

std::string glossary::comment(llvm::StringRef text, const std::string& scope, const std::string& header) const {
  std::string result;
  for (char before = ' '; !text.empty(); before = result.back()) {
    llvm::StringRef word = text.take_while([](char c) { return is_of_word(c) || c == '/' || c == '.'; }).rtrim("./");
    std::string translated;
    if (word.endswith(".hpp") && is_of_word(word.front())) {
      translated = file(word, header);
    } else if (is_of_word(text.front())) {
      const written_name one = name_at(text);
      const llvm::StringRef rest = text.substr(one.length);
      const bool marked = one.qualified || one.path.find('_') != std::string::npos || rest.startswith("(") ||
                          (before == '`' && rest.startswith("`"));
      if (marked && before != '.') translated = name(one.path, scope);
      word = one.qualified || !translated.empty() ? text.take_front(one.length) : word_at(text);
    } else {
      word = text.take_front(1);
    }
    result += translated.empty() ? word.str() : translated;
    text = text.drop_front(word.size());
  }
  return result;
}

std::string glossary::in_glsl(llvm::StringRef text, const std::string& scope, const std::string& header) const {
  std::string result;
  while (!text.empty()) {
    const std::size_t begin = std::min(text.find("//"), text.size());
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    result += text.take_front(begin).str() + comment(text.slice(begin, end), scope, header);
    text = text.drop_front(end);
  }
  return result;
}

}  // namespace pelage::codegen
