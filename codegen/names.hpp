// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <clang/AST/Decl.h>

#include <string>

namespace pelage::codegen {

/// pelage::a_buffer::push -> pelage_a_buffer_push. Template arguments vanish.
[[nodiscard]] std::string global_name(const clang::NamedDecl* d);

/// What an operator that is a function is called: `multiply` for operator*(a, b); nothing for those without a name.
[[nodiscard]] std::string operator_name(const clang::NamedDecl* d);

/// PELAGE_K_BUFFER_K for the parameter K of pelage::k_buffer.
[[nodiscard]] std::string upper(std::string name);

/// Why a name cannot stand in GLSL, or nothing. Fields may bear the names of built-in functions, others not.
[[nodiscard]] std::string bad_name(const std::string& name, bool is_field);

/// The GLSL built-in that a function of std:: or glm:: becomes where both take the same arguments, or nothing.
[[nodiscard]] std::string builtin_function(const std::string& qualified);

/// In std:: or in glm::, members of their classes too.
[[nodiscard]] bool is_std(const clang::NamedDecl* d);
[[nodiscard]] bool is_glm(const clang::NamedDecl* d);

}  // namespace pelage::codegen
