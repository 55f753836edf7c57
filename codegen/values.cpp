// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Values: numbers as they are spelled or as the compiler knows them, and constructors with every part.
#include "names.hpp"
#include "translator.hpp"

#include <clang/Lex/Lexer.h>

#include <charconv>
#include <cmath>
#include <cstdlib>

namespace pelage::codegen {

using namespace clang;

namespace {

std::string with_point(std::string digits) {
  if (digits.find_first_of(".e") == std::string::npos) return digits + ".0";
  return digits.back() == '.' ? digits + "0" : digits;
}

std::string shortest(float value) {
  if (std::isinf(value)) return value > 0 ? "uintBitsToFloat(0x7f800000u)" : "uintBitsToFloat(0xff800000u)";
  if (std::isnan(value)) return "uintBitsToFloat(0x7fc00000u)";
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return with_point(std::string(text, end));
}

float to_float(llvm::APFloat value) {
  bool inexact = false;
  value.convert(llvm::APFloat::IEEEsingle(), llvm::APFloat::rmNearestTiesToEven, &inexact);
  return value.convertToFloat();
}

}  // namespace

/// A literal's text without its separators.
std::string translator::spelling(SourceLocation literal) const {
  llvm::SmallString<32> buffer;
  const SourceLocation where = sources_.getSpellingLoc(literal);
  std::string text = Lexer::getSpelling(where, buffer, sources_, context_.getLangOpts()).str();
  std::erase(text, '\'');
  return text;
}

/// As it is spelled, where that means the same float in both languages.
std::string translator::literal(const FloatingLiteral* l) {
  const float wanted = to_float(l->getValue());
  std::string text = spelling(l->getBeginLoc());
  text.erase(text.find_last_not_of("fFlL") + 1);
  const bool decimal = text.find_first_not_of("0123456789.e+-") == std::string::npos && !text.empty();
  return decimal && std::strtof(text.c_str(), nullptr) == wanted ? with_point(text) : shortest(wanted);
}

std::string translator::literal(const IntegerLiteral* l, QualType as) {
  const std::string digits = llvm::toString(l->getValue(), 10, false);
  if (as->isFloatingType()) return with_point(digits);
  if (as->isBooleanType()) return l->getValue() == 0 ? "false" : "true";
  if (context_.getTypeSize(as) < 32) return reject(l, narrow);
  const std::string spelled = spelling(l->getBeginLoc());
  return (spelled.rfind("0x", 0) == 0 ? spelled.substr(0, spelled.find_first_of("uUlL")) : digits) + suffix(as);
}

std::string translator::suffix(QualType integer) const {
  return std::string(integer->isUnsignedIntegerType() ? "u" : "") + (context_.getTypeSize(integer) == 64 ? "l" : "");
}

/// A value that the compiler knows, as a literal, or nothing.
std::string translator::constant(const Expr* e) {
  Expr::EvalResult result;
  if (!e->EvaluateAsRValue(result, context_) || result.HasSideEffects) return {};
  if (result.Val.isFloat()) return shortest(to_float(result.Val.getFloat()));
  if (!result.Val.isInt()) return {};
  if (e->getType()->isBooleanType()) return result.Val.getInt() == 0 ? "false" : "true";
  return llvm::toString(result.Val.getInt(), 10) + suffix(e->getType());
}

/// The value of an expression of constants as glslang computes it, in double, from the decimals; or nothing.
std::optional<double> translator::folded(const Expr* e) {
  e = e->IgnoreParenCasts();
  if (const auto* x = dyn_cast<FloatingLiteral>(e)) return std::strtod(literal(x).c_str(), nullptr);
  if (const auto* x = dyn_cast<IntegerLiteral>(e)) return static_cast<double>(x->getValue().getZExtValue());
  if (const auto* x = dyn_cast<DeclRefExpr>(e)) {
    const auto* v = dyn_cast<VarDecl>(x->getDecl());
    const Expr* init = v == nullptr || !v->getType().isConstQualified() ? nullptr : v->getAnyInitializer();
    return init == nullptr ? std::nullopt : folded(init);
  }
  if (const auto* x = dyn_cast<UnaryOperator>(e); x != nullptr && x->getOpcode() == UO_Minus) {
    const std::optional<double> value = folded(x->getSubExpr());
    return value ? std::optional(-*value) : std::nullopt;
  }
  const auto* x = dyn_cast<BinaryOperator>(e);
  const std::optional<double> left = x == nullptr ? std::nullopt : folded(x->getLHS());
  const std::optional<double> right = left ? folded(x->getRHS()) : std::nullopt;
  if (!right) return std::nullopt;
  if (x->getOpcode() == BO_Add) return *left + *right;
  if (x->getOpcode() == BO_Sub) return *left - *right;
  if (x->getOpcode() == BO_Mul) return *left * *right;
  return x->getOpcode() == BO_Div ? std::optional(*left / *right) : std::nullopt;
}

/// C++ rounds each step of a constant expression to float; where glslang gets another value, the mirror holds the
/// result in the expression's place. Nothing elsewhere.
std::string translator::rounded(const BinaryOperator* x) {
  if (!x->getType()->isFloatingType() || has_size(x)) return {};
  const std::string exact = constant(x);
  const std::optional<double> value = exact.empty() ? std::nullopt : folded(x);
  return value && exact == shortest(static_cast<float>(*value)) ? std::string() : exact;
}

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
  if (!is_std_type(type, "array")) return type_of(type, where) + "(" + listed(values) + ")";
  const auto* inner = values.empty() ? nullptr : dyn_cast<InitListExpr>(values.front()->IgnoreImplicit());
  if (inner == nullptr) return zero(type, where);
  return array_value(type, {inner->inits().begin(), inner->inits().end()}, where);
}

std::string translator::construct(const CXXConstructExpr* c) {
  const CXXConstructorDecl* made = c->getConstructor();
  const SourceLocation where = c->getBeginLoc();
  if (made->isCopyOrMoveConstructor() && c->getNumArgs() == 1) return kept(c, glsl(c->getArg(0)));
  if (is_in(made, "glm")) {
    if (c->getNumArgs() == 0) return reject(where, "vector without a value");
    return type_of(c->getType(), where) + "(" + listed({c->arg_begin(), c->arg_end()}) + ")";
  }
  if (c->getNumArgs() == 0 && (made->isTrivial() || !made->isUserProvided())) return zero(c->getType(), where);
  return reject(
      where, "constructor of " + made->getParent()->getQualifiedNameAsString() + ": only aggregates are in the subset");
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
  return type_of(type, where) + "(" + parts + ")";
}

/// T{} for what has a fixed number of parts.
std::string translator::zero(QualType t, SourceLocation where) {
  const std::string type = type_of(t, where);
  if (type.back() == ']') return array_value(t, {}, where);
  const auto* record = t->getAsCXXRecordDecl();
  if (record != nullptr && !is_in(record, "glm")) {
    std::string parts;
    for (const FieldDecl* f : record->fields())
      parts += (parts.empty() ? "" : ", ") + zero(f->getType(), where);
    return type + "(" + parts + ")";
  }
  return llvm::StringSwitch<std::string>(type)
      .Case("float", "0.0")
      .Case("bool", "false")
      .Case("int", "0")
      .Case("uint", "0u")
      .Default(type + "(0)");
}

}  // namespace pelage::codegen
