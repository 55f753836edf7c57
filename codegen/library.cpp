// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What functions of std:: and glm:: are in GLSL.
#include "names.hpp"
#include "translator.hpp"

#include <algorithm>

namespace pelage::codegen {

using namespace clang;

namespace {

/// What a function's result is: a float, a vector of floats, a count of bits of a 32-bit word, or anything else.
enum class result_kind { scalar, vector, bits, other };

/// A call written in GLSL: $0, $1 and $2 are its arguments, #0, #1 and #2 likewise, in parentheses if need be.
struct form {
  const char* function;
  result_kind of;
  const char* text;
};

/// GLSL leaves min, max and clamp of NaN open: comparisons say what std:: and glm:: do.
constexpr form forms[] = {
    {"min", result_kind::scalar, "(#1 < #0 ? #1 : #0)"},
    {"max", result_kind::scalar, "(#0 < #1 ? #1 : #0)"},
    {"clamp", result_kind::scalar, "(#0 < #1 ? #1 : (#2 < #0 ? #2 : #0))"},
    {"min", result_kind::vector, "mix($0, $1, lessThan($1, $0))"},
    {"max", result_kind::vector, "mix($0, $1, lessThan($0, $1))"},
    {"clamp", result_kind::vector,
     "mix(mix($0, $1, lessThan($0, $1)), $2, lessThan($2, mix($0, $1, lessThan($0, $1))))"},
    {"min", result_kind::other, "min($0, $1)"},
    {"max", result_kind::other, "max($0, $1)"},
    {"clamp", result_kind::other, "clamp($0, $1, $2)"},
    {"countl_zero", result_kind::bits, "(31 - findMSB($0))"},
    {"countr_zero", result_kind::bits, "(#0 == 0u ? 32 : findLSB($0))"},
    {"bit_width", result_kind::bits, "(findMSB($0) + 1)"},
    {"popcount", result_kind::bits, "bitCount($0)"},
    {"atomic_thread_fence", result_kind::other, "PELAGE_FENCE()"},
};

std::string grouped(const std::string& text) {
  return text.find(' ') == std::string::npos && text.front() != '-' ? text : "(" + text + ")";
}

std::string filled(const form& f, const std::vector<std::string>& arguments) {
  std::string text;
  for (const char* c = f.text; *c != '\0'; ++c) {
    if (*c != '$' && *c != '#') {
      text += *c;
      continue;
    }
    const std::string& argument = arguments.at(static_cast<std::size_t>(c[1] - '0'));
    text += *c == '$' ? argument : grouped(argument);
    ++c;
  }
  return text;
}

bool has_float(QualType t) {
  return t->isFloatingType() || (t->getAsCXXRecordDecl() != nullptr && is_glm(t->getAsCXXRecordDecl()));
}

}  // namespace

/// Functions of std:: and glm::.
std::string translator::library_call(const CallExpr* c, const FunctionDecl* f) {
  const SourceLocation where = c->getBeginLoc();
  std::string name = f->getQualifiedNameAsString();
  if (f->getBuiltinID() != 0 && name.find("::") == std::string::npos) name = "std::" + name;
  const std::string bare = name.substr(name.rfind(':') + 1);
  if (c->getNumArgs() == 0) {
    const std::string value = constant(c);
    if (!value.empty()) return value;
  }
  if (name == "std::bit_cast") return bit_cast(c);
  if (bare == "round") return reject(where, "round: GLSL leaves halves open");
  const QualType result = c->getType().getNonReferenceType();
  const bool scalar = result->isFloatingType();
  const bool vector = !scalar && has_float(result) && type_of(result, where).text().rfind("vec", 0) == 0;
  const form* known = std::find_if(std::begin(forms), std::end(forms), [&](const form& one) {
    const bool fits = one.of == result_kind::scalar ? scalar : one.of == result_kind::vector ? vector : true;
    return bare == one.function && fits;
  });
  std::vector<std::string> arguments;
  for (const Expr* a : c->arguments()) {
    const bool spread = known != std::end(forms) && vector && a->getType().getNonReferenceType()->isFloatingType();
    arguments.push_back(spread ? type_of(result, where).text() + "(" + glsl(a) + ")" : glsl(a));
  }
  if (name == "std::swap") {
    const std::string first = type_of(c->getArg(0)->getType(), where).declare("pelage_first");
    return "{\nconst " + first + " = " + arguments[0] + ";\n" + arguments[0] + " = " + arguments[1] + ";\n" +
           arguments[1] + " = pelage_first;\n}";
  }
  if (known == std::end(forms)) {
    const std::string same = builtin_function(name);
    if (same.empty()) return reject(where, name + " has no GLSL form here");
    arithmetic_ = arithmetic_ || has_float(result);
    return same + "(" + llvm::join(arguments, ", ") + ")";
  }
  const std::string text = filled(*known, arguments);
  if (known->of != result_kind::bits) return text;
  if (context_.getTypeSize(c->getArg(0)->getType()) != 32) return reject(where, name + " of other than 32 bits");
  // An int in GLSL, and in C++ whatever the library says.
  return context_.hasSameUnqualifiedType(result, context_.IntTy) ? text : type_of(result, where).text() + text;
}

std::string translator::bit_cast(const CallExpr* c) {
  static const std::map<std::string, std::string> floats = {{"float uint", "floatBitsToUint"},
                                                            {"float int", "floatBitsToInt"},
                                                            {"uint float", "uintBitsToFloat"},
                                                            {"int float", "intBitsToFloat"},
                                                            {"int uint", "uint"},
                                                            {"uint int", "int"}};
  const std::string to = type_of(c->getType(), c->getBeginLoc()).text();
  const std::string from = type_of(c->getArg(0)->getType(), c->getBeginLoc()).text();
  const auto found = floats.find(from + " " + to);
  if (found == floats.end()) return reject(c->getBeginLoc(), "std::bit_cast from " + from + " to " + to);
  return found->second + "(" + glsl(c->getArg(0)) + ")";
}

}  // namespace pelage::codegen
