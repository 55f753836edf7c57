// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What functions of std:: and glm:: are in GLSL.
#include "names.hpp"
#include "translator.hpp"

namespace pelage::codegen {

using namespace clang;

namespace {

/// What a function's result is: a float, a vector of floats, a count of bits of a 32-bit word, or anything else.
enum class result_kind { scalar, vector, bits, other };

/// A call written in GLSL: {0}, {1} and {2} are its arguments, {3}, {4} and {5} likewise, in parentheses if need be.
struct form {
  const char* function;
  result_kind of;
  const char* text;
};

/// GLSL leaves min, max and clamp of NaN open: comparisons say what std:: and glm:: do.
constexpr form forms[] = {
    {"min", result_kind::scalar, "({4} < {3} ? {4} : {3})"},
    {"max", result_kind::scalar, "({3} < {4} ? {4} : {3})"},
    {"clamp", result_kind::scalar, "({3} < {4} ? {4} : ({5} < {3} ? {5} : {3}))"},
    {"min", result_kind::vector, "mix({0}, {1}, lessThan({1}, {0}))"},
    {"max", result_kind::vector, "mix({0}, {1}, lessThan({0}, {1}))"},
    {"clamp", result_kind::vector,
     "mix(mix({0}, {1}, lessThan({0}, {1})), {2}, lessThan({2}, mix({0}, {1}, lessThan({0}, {1}))))"},
    {"min", result_kind::other, "min({0}, {1})"},
    {"max", result_kind::other, "max({0}, {1})"},
    {"clamp", result_kind::other, "clamp({0}, {1}, {2})"},
    {"countl_zero", result_kind::bits, "(31 - findMSB({0}))"},
    {"countr_zero", result_kind::bits, "({3} == 0u ? 32 : findLSB({0}))"},
    {"bit_width", result_kind::bits, "(findMSB({0}) + 1)"},
    {"popcount", result_kind::bits, "bitCount({0})"},
    {"atomic_thread_fence", result_kind::other, "PELAGE_FENCE()"},
};

/// std::bit_cast by the types that it leads from and to.
const std::map<std::string, std::string> bit_casts = {
    {"float uint", "floatBitsToUint"}, {"float int", "floatBitsToInt"}, {"uint float", "uintBitsToFloat"},
    {"int float", "intBitsToFloat"},   {"int uint", "uint"},            {"uint int", "int"}};

std::string grouped(const std::string& text) {
  return text.find(' ') == std::string::npos && text.front() != '-' ? text : "(" + text + ")";
}

bool has_float(QualType t) {
  return t->isFloatingType() || (t->isRecordType() && is_in(t->getAsCXXRecordDecl(), "glm"));
}

}  // namespace

/// Functions of std:: and glm::.
std::string translator::library_call(const CallExpr* c, const FunctionDecl* f) {
  const SourceLocation where = c->getBeginLoc();
  const std::string name = f->getQualifiedNameAsString();
  const std::string bare = llvm::StringSwitch<std::string>(name.substr(name.rfind(':') + 1))
                               .Case("fabs", "abs")
                               .Case("atan2", "atan")
                               .Case("not_", "not")
                               .Default(name.substr(name.rfind(':') + 1));
  if (c->getNumArgs() == 0) {
    const std::string value = constant(c);
    if (!value.empty()) return value;
  }
  if (bare == "round") return reject(where, "round: GLSL leaves halves open");
  const std::string type = has_float(c->getType()) ? type_of(c->getType(), where).text() : std::string();
  const bool vector = type.rfind("vec", 0) == 0;
  const auto* known = llvm::find_if(forms, [&](const form& one) {
    return bare == one.function && (one.of != result_kind::scalar || type == "float") &&
           (one.of != result_kind::vector || vector);
  });
  std::vector<std::string> arguments;
  for (const Expr* a : c->arguments()) {
    const bool spread = known != std::end(forms) && vector && a->getType()->isFloatingType();
    arguments.push_back(spread ? type + "(" + glsl(a) + ")" : glsl(a));
  }
  if (name == "std::bit_cast") {
    const std::string from = type_of(c->getArg(0)->getType(), where).text();
    const std::string to = type_of(c->getType(), where).text();
    const auto found = bit_casts.find(from + " " + to);
    if (found == bit_casts.end()) return reject(where, "std::bit_cast from " + from + " to " + to);
    return found->second + "(" + arguments[0] + ")";
  }
  if (name == "std::swap") {
    return filled("{{\nconst {0} = {1};\n{1} = {2};\n{2} = pelage_first;\n}",
                  type_of(c->getArg(0)->getType(), where).declare("pelage_first"), arguments[0], arguments[1]);
  }
  if (known == std::end(forms)) {
    const bool writes = llvm::any_of(f->parameters(), [](const ParmVarDecl* p) { return writes_to(p->getType()); });
    if (writes || !is_builtin(bare)) return reject(where, name + " has no GLSL form here");
    arithmetic_ = arithmetic_ || has_float(c->getType());
    return bare + "(" + llvm::join(arguments, ", ") + ")";
  }
  if (known->of == result_kind::bits && context_.getTypeSize(c->getArg(0)->getType()) != 32) {
    return reject(where, name + " of other than 32 bits");
  }
  arguments.resize(3, "0");
  const std::string text = filled(known->text, arguments[0], arguments[1], arguments[2], grouped(arguments[0]),
                                  grouped(arguments[1]), grouped(arguments[2]));
  // A count of bits is an int in GLSL, and in C++ whatever the library says.
  const bool count = known->of == result_kind::bits && !context_.hasSameUnqualifiedType(c->getType(), context_.IntTy);
  return count ? type_of(c->getType(), where).text() + text : text;
}

}  // namespace pelage::codegen
