// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Calls: of our own functions, of what std:: and glm:: have, and operators.
#include "names.hpp"
#include "translator.hpp"

namespace pelage::codegen {

using namespace clang;

namespace {

/// What a function's result is: a float, a vector of floats, a count of bits of a 32-bit word, or anything else.
enum class result_kind { scalar, vector, bits, other };

/// A call written in GLSL: {0}, {1} and {2} are its arguments, {3}, {4} and {5} the same, in parentheses if need be.
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

/// What std:: and glm:: call otherwise.
const std::map<std::string, std::string> other_names = {{"fabs", "abs"}, {"atan2", "atan"}, {"not_", "not"}};

/// std::bit_cast by the types that it leads from and to.
const std::map<std::string, std::string> bit_casts = {{"float uint", "floatBitsToUint"},
                                                      {"float int", "floatBitsToInt"},
                                                      {"uint float", "uintBitsToFloat"},
                                                      {"int float", "intBitsToFloat"},
                                                      {"int uint", "uint"},
                                                      {"uint int", "int"}};

std::string grouped(const std::string& text) {
  return text.find(' ') == std::string::npos && text.front() != '-' ? text : "(" + text + ")";
}

bool has_float(QualType t) {
  return t->isFloatingType() || (t->isRecordType() && is_in(t->getAsCXXRecordDecl(), "glm"));
}

/// True where one path leads to the other's place or into it: slot and slot[i].depth, but not slot[i] and slot[j].
bool overlap(const std::string& a, const std::string& b) {
  const auto& [shorter, longer] = std::minmax(a, b, [](auto& x, auto& y) { return x.size() < y.size(); });
  if (longer.compare(0, shorter.size(), shorter) != 0) return false;
  return longer.size() == shorter.size() || longer[shorter.size()] == '.' || longer[shorter.size()] == '[';
}

}  // namespace

/// A call of one of our own functions, storage left out. Checks what C++ and GLSL would do differently: order of
/// effects, and inout copies of places that are one place in C++.
std::string translator::call(const CallExpr* c, const FunctionDecl* f, position at) {
  const std::string name = use(f, c->getBeginLoc());
  bind_sizes(f, {});
  std::vector<std::string> all;
  std::vector<std::pair<std::string, bool>> places;  // path, written to
  bool effects = false;
  const auto pass = [&](const Expr* argument, bool by_reference, bool writes) {
    effects = effects || writes;
    if (is_storage(argument->getType())) return;
    all.push_back(isa<CXXThisExpr>(argument->IgnoreParenImpCasts()) ? "self" : glsl(argument));
    if (by_reference) places.emplace_back(all.back(), writes);
  };
  if (const auto* method = dyn_cast<CXXMethodDecl>(f)) {
    bind_sizes(method->getParent(), {});
    const auto* of_object = dyn_cast<CXXMemberCallExpr>(c);
    if (of_object != nullptr && !method->isStatic()) {
      pass(of_object->getImplicitObjectArgument(), true, !method->isConst());
    }
  }
  for (const ParmVarDecl* p : f->parameters()) {
    pass(c->getArg(p->getFunctionScopeIndex()), p->getType()->isReferenceType(), writes_to(p->getType()));
  }
  for (auto one = places.begin(); one != places.end(); ++one) {
    for (auto other = places.begin(); other != one; ++other) {
      if ((one->second || other->second) && overlap(one->first, other->first)) {
        reject(c, filled("aliasing arguments: `{0}` and `{1}` share a place that the call writes to", other->first,
                         one->first));
      }
    }
  }
  if (effects && at == position::part) return reject(c, effect_inside);
  return name + "(" + llvm::join(all, ", ") + ")";
}

std::string translator::call(const CallExpr* c, position at) {
  const FunctionDecl* f = c->getDirectCallee();
  if (f == nullptr) return reject(c, "call through a pointer or of a callable object");
  const std::string name = f->getQualifiedNameAsString();
  // std::atomic_ref has no minimum and maximum before C++26: the library's own stand for GLSL's.
  if (name == "pelage::fetch_minimum") return atomic(c, c->getArg(0), "fetch_min", 1, at);
  if (name == "pelage::fetch_maximum") return atomic(c, c->getArg(0), "fetch_max", 1, at);
  if (const auto* m = dyn_cast<CXXMemberCallExpr>(c)) {
    const Expr* object = m->getImplicitObjectArgument();
    if (llvm::StringRef(name).startswith("std::atomic_ref") || llvm::StringRef(name).startswith("std::__atomic_ref")) {
      return atomic(c, object, f->getNameAsString(), 0, at);
    }
    if (is_std_type(object->getType(), "span")) {
      return reject(c, "a span's size is a size_t: write static_cast<std::uint32_t>(x.size())");
    }
  }
  const bool library = is_in(f, "std") || is_in(f, "glm") || f->getBuiltinID() != 0;
  return library ? library_call(c, f) : call(c, f, at);
}

std::string translator::operator_call(const CXXOperatorCallExpr* c, position at) {
  const OverloadedOperatorKind op = c->getOperator();
  const FunctionDecl* f = c->getDirectCallee();
  const QualType left = c->getArg(0)->getType();
  if (f == nullptr || op == OO_Call) return reject(c, "call through a pointer or of a callable object");
  const bool vector = is_in(f, "glm");
  if (op == OO_Subscript && (vector || is_std_type(left, "array") || is_std_type(left, "span"))) {
    // The index is a size_t in C++; its own type will do here.
    const std::string index = glsl(c->getArg(1)->IgnoreImplicit());
    if (is_std_type(left, "span")) return cell_macro(c->getArg(0), "", "(i)") + "(" + index + ")";
    return glsl(c->getArg(0)) + "[" + index + "]";
  }
  const auto* method = dyn_cast<CXXMethodDecl>(f);
  const bool copies = op == OO_Equal && method != nullptr && !method->isUserProvided();
  if (!vector && !copies) {
    // An operator of ours is a function by another name, as long as it changes nothing.
    if (method == nullptr && !operator_name(f).empty()) return call(c, f, at);
    return reject(c->getOperatorLoc(), "operator overload: call a function instead");
  }
  const bool assigns = c->isAssignmentOp();
  if (assigns && at == position::part) return reject(c->getOperatorLoc(), assignment_inside);
  if (op == OO_PlusPlus || op == OO_MinusMinus) return reject(c->getOperatorLoc(), "increment of a vector");
  arithmetic_ = arithmetic_ || vector;
  const std::string spelled = getOperatorSpelling(op);
  if (c->getNumArgs() == 1) return prefixed(spelled, glsl(c->getArg(0)));
  return glsl(c->getArg(0)) + " " + spelled + " " + glsl(c->getArg(1), assigns ? position::whole : position::part);
}

/// Functions of std:: and glm::.
std::string translator::library_call(const CallExpr* c, const FunctionDecl* f) {
  const SourceLocation where = c->getBeginLoc();
  const std::string name = f->getQualifiedNameAsString();
  std::string bare = name.substr(name.rfind(':') + 1);
  if (const auto other = other_names.find(bare); other != other_names.end()) bare = other->second;
  if (const std::string value = c->getNumArgs() == 0 ? constant(c) : ""; !value.empty()) return value;
  if (bare == "round") return reject(where, "round: GLSL leaves halves open");
  const std::string type = has_float(c->getType()) ? type_of(c->getType(), where) : std::string();
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
    const std::string from = type_of(c->getArg(0)->getType(), where);
    const std::string to = type_of(c->getType(), where);
    const auto found = bit_casts.find(from + " " + to);
    if (found == bit_casts.end()) return reject(where, "std::bit_cast from " + from + " to " + to);
    return found->second + "(" + arguments[0] + ")";
  }
  if (name == "std::swap") {
    return filled("{{\n{0} pelage_first = {1};\n{1} = {2};\n{2} = pelage_first;\n}",
                  "const " + type_of(c->getArg(0)->getType(), where), arguments[0], arguments[1]);
  }
  if (known == std::end(forms)) {
    const bool writes = llvm::any_of(f->parameters(), [](const ParmVarDecl* p) { return writes_to(p->getType()); });
    if (writes || isa<CXXMethodDecl>(f) || !is_builtin(bare)) return reject(where, name + " has no GLSL form here");
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
  return count ? type_of(c->getType(), where) + text : text;
}

}  // namespace pelage::codegen
