// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <clang/AST/Decl.h>
#include <clang/Basic/SourceManager.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace clang {
class Preprocessor;
}

namespace pelage::codegen {

/// Everything that lies outside of the subset, each with its place. All of it is reported, in the order of the
/// source, and nothing is written when there is any.
class problems {
 public:
  explicit problems(const clang::SourceManager& sources) : sources_(sources) {}
  void add(clang::SourceLocation where, const std::string& reason);
  [[nodiscard]] bool report() const;  ///< true if there are any

 private:
  const clang::SourceManager& sources_;
  std::set<std::tuple<std::string, unsigned, std::string>> found_;  ///< file, line, reason
};

struct unit;

/// One global name of the mirror: a structure, a function, a constant or an enumeration.
struct entity {
  std::string name;         ///< in GLSL
  std::string qualified;    ///< in C++
  std::string signature;    ///< name and parameter types: what two overloads must not share
  std::string doc;          ///< lines that begin with ///
  std::string declaration;  ///< a function's prototype without `;`, the whole text of anything else
  std::string body;         ///< a function's `{ ... }`
  unit* where = nullptr;
  std::pair<unsigned, unsigned> declared_at;  ///< place in the header: offset, then rank
  unsigned defined_at = 0;                    ///< offset of a function's body's declaration
  std::vector<std::pair<const entity*, clang::SourceLocation>> needs;
  std::map<std::string, std::string> inner;     ///< names declared within, in C++ and in GLSL
  std::set<std::string> sizes;                  ///< size macros that the text names
  std::map<std::string, std::string> bindings;  ///< size macros of what it calls, and their values
  clang::SourceLocation location;
  bool sized = false;  ///< depends on a size macro, itself or through what it needs
  [[nodiscard]] bool is_function() const { return !body.empty(); }
};

/// A cell or a span of cells that the shader provides.
struct cell {
  std::string call;  ///< how the mirror writes it: MACRO or MACRO(i)
  std::string doc;
  std::string scope;  ///< where the names of `doc` are looked up
};

/// A static_assert over sizes.
struct condition {
  std::set<std::string> sizes;  ///< their macros
  std::string text;
  std::string message;
};

/// One header and the .glsl that mirrors it.
struct unit {
  std::string header;     ///< as a program includes it: pelage/order/k_buffer.hpp
  std::string name;       ///< of the file, as a header's: pelage/order/k_buffer.glsl
  std::string path;       ///< below the output folder: order/k_buffer.glsl
  std::string include;    ///< how others include it where `path` will not do: library files seen from a user's
  bool mirrored = false;  ///< already there: a library header seen from a user's
  std::string mirror_text;
  std::vector<std::pair<std::string, std::string>> docs;  ///< namespaces, and what the header says above them
  std::vector<const entity*> entities;
  std::map<std::string, std::string> sizes;  ///< macros through which a shader picks a template's size: defaults
  std::vector<condition> conditions;         ///< in the header's order
  std::map<std::string, cell> cells;
  std::set<std::string> memory_orders;  ///< of the files below
  bool uses_int64 = false;
  bool uses_subgroup = false;
};

/// The headers of one translation unit, each with what its mirror holds.
class headers {
 public:
  /// `library`: the headers of pelage/ are what is written, not what is there already.
  headers(clang::Preprocessor& preprocessor, bool library);

  /// The unit of a header of ours or of the translation unit's own file, or null for the rest of the world. `wide`:
  /// that of its storage of 64-bit words, a file of its own, which shaders without 64-bit integers do not include.
  unit* unit_of(clang::FileID file, bool wide = false);

  /// True for what stands in the translation unit's own file or in a header that it includes itself.
  bool is_named(const clang::Decl* d);

  /// Notes what stands above a namespace, or by itself at its beginning: it tells about the whole header.
  void note_doc(const clang::NamespaceDecl* space);

  /// The units that something was written to.
  [[nodiscard]] std::vector<const unit*> written() const;

  /// The headers that have a mirror.
  [[nodiscard]] std::set<std::string> mirrored() const;

 private:
  clang::Preprocessor& preprocessor_;
  clang::SourceManager& sources_;
  bool library_;
  std::set<const clang::FileEntry*> named_;  ///< included by the translation unit's own file
  std::map<std::pair<const clang::FileEntry*, bool>, std::unique_ptr<unit>> units_;
};

/// What comments that speak of C++ say in GLSL.
struct glossary {
  std::map<std::string, std::string> names;  ///< by qualified names
  std::set<std::string> headers;             ///< those that have a mirror

  /// A text's comments with the mirror's names: of what has one, each call, qualified name, name in backticks or with
  /// `_` in it, found from a scope outward as C++ finds it; and each header. Other words stay.
  [[nodiscard]] std::string in_glsl(llvm::StringRef text, const std::string& scope, const std::string& header) const;

 private:
  [[nodiscard]] std::string comment(llvm::StringRef text, const std::string& scope, const std::string& header) const;
  [[nodiscard]] std::string name(const std::string& written, const std::string& scope) const;
  [[nodiscard]] std::string file(llvm::StringRef written, const std::string& header) const;
};

/// How every file begins.
inline constexpr const char* licence = "// Copyright (c) 2026 The Pelage authors\n// SPDX-License-Identifier: MIT\n";

/// The whole text of one .glsl, formatted.
[[nodiscard]] std::string file_text(const unit& u, const glossary& words, problems& found);

/// What files with atomics include, of 32 and of 64 bits: their paths below the output folder, and their texts.
inline constexpr const char* memory_order_path = "core/memory_order.glsl";
inline constexpr const char* memory_order_64_path = "core/memory_order_64.glsl";
[[nodiscard]] std::string memory_order_text(const std::string& path);

/// Files' texts by their paths.
using texts = std::map<std::string, std::string>;

}  // namespace pelage::codegen
