// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <clang/AST/Decl.h>
#include <llvm/Support/FormatVariadic.h>

#include <string>

namespace pelage::codegen {

/// pelage::a_buffer::push, as one writes it: without template arguments, inline and anonymous namespaces.
[[nodiscard]] std::string qualified_name(const clang::NamedDecl* d);

/// True for storage that is a template of its words, instantiated with a 64-bit integer.
[[nodiscard]] bool is_wide(const clang::DeclContext* record);

/// pelage::a_buffer::push -> pelage_a_buffer_push. Template arguments vanish, except that what is_wide() says _64.
[[nodiscard]] std::string global_name(const clang::NamedDecl* d);

/// What an operator that is a function is called: `multiply` for operator*(a, b); nothing for those without a name.
[[nodiscard]] std::string operator_name(const clang::NamedDecl* d);

/// A text with {0}, {1} and so on in it, filled.
template <class... Parts>
[[nodiscard]] std::string filled(const char* format, Parts&&... parts) {
  return llvm::formatv(format, std::forward<Parts>(parts)...).str();
}

/// An expression of sizes without the literals' suffixes, which the preprocessor does not know.
[[nodiscard]] std::string preprocessed(const std::string& expression);

/// An operator before its operand: -(-x), for --x is something else.
[[nodiscard]] inline std::string prefixed(const std::string& op, const std::string& operand) {
  return op + (operand.rfind(op, 0) == 0 ? "(" + operand + ")" : operand);
}

/// Why a name cannot stand in GLSL, or nothing. Fields may bear the names of built-in functions, others not.
[[nodiscard]] std::string bad_name(const std::string& name, bool is_field);

/// The lines of a declaration's documentation, ///< beside it or /// above it.
[[nodiscard]] std::string doc_of(const clang::Decl* d, bool beside);

/// True for the names of GLSL's own functions.
[[nodiscard]] bool is_builtin(const std::string& name);

/// In a namespace or in one of its classes.
[[nodiscard]] bool is_in(const clang::NamedDecl* d, const std::string& space);

/// std::span and the like, or a reference to it.
[[nodiscard]] bool is_std_type(clang::QualType t, llvm::StringRef name);

}  // namespace pelage::codegen
