// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Values of several parts: constructors with every part, those not given 0.
#include "names.hpp"
#include "translator.hpp"

namespace pelage::codegen {

using namespace clang;

std::string translator::listed(const std::vector<const Expr*>& values) {
  std::vector<std::string> all;
  for (const Expr* value : values)
    all.push_back(glsl(value));
  return llvm::join(all, ", ");
}

/// fragment{a, b} and std::array<T, N>{a, b}.
std::string translator::initializer_list(const InitListExpr* l) {
  if (const InitListExpr* semantic = l->getSemanticForm()) l = semantic;
  const QualType type = l->getType();
  const SourceLocation where = l->getBeginLoc();
  const std::vector<const Expr*> values(l->inits().begin(), l->inits().end());
  if (!type->isRecordType()) {
    if (values.empty()) return zero(type, where);
    return values.size() == 1 ? glsl(values.front()) : reject(where, "list of values");
  }
  if (!is_std_type(type, "array")) return type_of(type, where).text() + "(" + listed(values) + ")";
  const auto* inner = values.empty() ? nullptr : dyn_cast<InitListExpr>(values.front()->IgnoreImplicit());
  if (inner == nullptr) return zero(type, where);
  return array_value(type, {inner->inits().begin(), inner->inits().end()}, where);
}

std::string translator::construct(const CXXConstructExpr* c) {
  const CXXConstructorDecl* made = c->getConstructor();
  const SourceLocation where = c->getBeginLoc();
  if (made->isCopyOrMoveConstructor() && c->getNumArgs() == 1) return glsl(c->getArg(0));
  if (is_in(made, "glm")) {
    if (c->getNumArgs() == 0) return reject(where, "vector without a value");
    return type_of(c->getType(), where).text() + "(" + listed({c->arg_begin(), c->arg_end()}) + ")";
  }
  if (c->getNumArgs() == 0 && (made->isTrivial() || !made->isUserProvided())) return zero(c->getType(), where);
  return reject(where, "constructor of " + made->getParent()->getQualifiedNameAsString() +
                           ": only aggregates are in the subset");
}

/// An array's elements must not be for a macro to count.
std::string translator::array_value(QualType type, const std::vector<const Expr*>& given, SourceLocation where) {
  const array a = *array_of(type.getUnqualifiedType());
  if (a.sized || a.count > given.size() + 16) {
    return reject(where, "an array of many zeros: declare it without a value and fill it in a loop");
  }
  std::string parts = listed(given);
  for (std::uint64_t i = given.size(); i < a.count; ++i)
    parts += (parts.empty() ? "" : ", ") + zero(a.element, where);
  return type_of(type, where).text() + "(" + parts + ")";
}

/// T{} for what has a fixed number of parts.
std::string translator::zero(QualType t, SourceLocation where) {
  const glsl_type type = type_of(t, where);
  if (!type.extents.empty()) return array_value(t, {}, where);
  const auto* record = t->getAsCXXRecordDecl();
  if (record != nullptr && !is_in(record, "glm")) {
    std::string parts;
    for (const FieldDecl* f : record->fields())
      parts += (parts.empty() ? "" : ", ") + zero(f->getType(), where);
    return type.name + "(" + parts + ")";
  }
  return llvm::StringSwitch<std::string>(type.name)
      .Case("float", "0.0")
      .Case("bool", "false")
      .Case("int", "0")
      .Case("uint", "0u")
      .Default(type.name + "(0)");
}

}  // namespace pelage::codegen
