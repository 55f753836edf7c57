// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "names.hpp"
#include "translator.hpp"

namespace pelage::codegen {

using namespace clang;

namespace {

bool is_glm(const NamedDecl* d) {
  return d->getQualifiedNameAsString().rfind("glm::", 0) == 0;
}

/// In std::, members of its classes too.
bool is_std(const NamedDecl* d) {
  return d->getQualifiedNameAsString().rfind("std::", 0) == 0;
}

bool is_array_type(QualType t) {
  const CXXRecordDecl* r = t.getNonReferenceType()->getAsCXXRecordDecl();
  return r != nullptr && r->isInStdNamespace() && r->getName() == "array";
}

/// True where one path leads to the other's place or into it: slot and slot[i].depth, but not slot[i] and slot[j].
bool overlap(const std::string& a, const std::string& b) {
  const std::string& shorter = a.size() < b.size() ? a : b;
  const std::string& longer = a.size() < b.size() ? b : a;
  if (longer.compare(0, shorter.size(), shorter) != 0) return false;
  return longer.size() == shorter.size() || longer[shorter.size()] == '.' || longer[shorter.size()] == '[';
}

bool writes_to(QualType parameter) {
  return parameter->isLValueReferenceType() && !parameter.getNonReferenceType().isConstQualified();
}

bool has_float(QualType t) {
  if (t->isFloatingType()) return true;
  const CXXRecordDecl* r = t->getAsCXXRecordDecl();
  return r != nullptr && is_glm(r);
}

}  // namespace

/// The arguments of one of our own functions, storage left out. Checks what C++ and GLSL would do differently: order
/// of effects, and inout copies of places that are one place in C++.
std::string translator::arguments(const FunctionDecl* f, const std::vector<const Expr*>& args, const Expr* object,
                                  const Expr* whole_call, position at) {
  std::string text;
  std::vector<std::pair<std::string, bool>> places;  // path, written to
  bool effects = false;
  if (object != nullptr) {
    const bool writes = !cast<CXXMethodDecl>(f)->isConst();
    text = isa<CXXThisExpr>(object->IgnoreParenImpCasts()) ? "self" : expression(object);
    places.emplace_back(text, writes);
    effects = writes;
  }
  for (std::size_t i = 0; i < args.size(); ++i) {
    const QualType parameter = f->getParamDecl(static_cast<unsigned>(i))->getType();
    if (is_storage_type(parameter)) {
      effects = effects || writes_to(parameter);
      continue;
    }
    const std::string one = expression(args[i]);
    if (parameter->isReferenceType()) places.emplace_back(one, writes_to(parameter));
    effects = effects || writes_to(parameter);
    text += (text.empty() ? "" : ", ") + one;
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if ((places[i].second || places[j].second) && overlap(places[i].first, places[j].first)) {
        reject(whole_call->getBeginLoc(), "aliasing arguments: `" + places[j].first + "` and `" + places[i].first +
                                              "` share a place that the call writes to");
      }
    }
  }
  if (effects && at == position::part) {
    reject(whole_call->getBeginLoc(), "call with an effect inside an expression: give its result a name first");
  }
  return text;
}

std::string translator::call(const CallExpr* c, position at) {
  const FunctionDecl* f = c->getDirectCallee();
  if (f == nullptr) return reject(c->getBeginLoc(), "call through a pointer or of a callable object");
  const std::vector<const Expr*> args(c->arg_begin(), c->arg_end());
  const Expr* object = nullptr;
  if (const auto* m = dyn_cast<CXXMemberCallExpr>(c)) {
    object = m->getImplicitObjectArgument();
    if (is_array_type(object->getType())) {
      return reject(c->getBeginLoc(), "std::array::" + f->getNameAsString() + ": only [] is in the subset");
    }
    if (is_glm(f)) return reject(c->getBeginLoc(), f->getQualifiedNameAsString() + " is not in the subset");
    if (m->getMethodDecl()->isVirtual()) return reject(c->getBeginLoc(), "virtual function");
  }
  if (is_std(f) || is_glm(f) || f->getBuiltinID() != 0) return library_call(c, f);
  if (f->isVariadic()) return reject(c->getBeginLoc(), "variadic function");
  if (isa<CXXConversionDecl>(f)) return reject(c->getBeginLoc(), "conversion operator");
  const std::string name = use(f, c->getBeginLoc());
  bind_sizes(f, c->getCallee());
  const bool through_storage = object != nullptr && is_storage_type(object->getType());
  if (through_storage && !cast<CXXMethodDecl>(f)->isConst() && at == position::part) {
    reject(c->getBeginLoc(), "call with an effect inside an expression: give its result a name first");
  }
  const auto* method = dyn_cast<CXXMethodDecl>(f);
  const bool no_self = through_storage || (method != nullptr && method->isStatic());
  return name + "(" + arguments(f, args, no_self ? nullptr : object, c, at) + ")";
}

/// Functions of std:: and glm::.
std::string translator::library_call(const CallExpr* c, const FunctionDecl* f) {
  std::string name = f->getQualifiedNameAsString();
  if (f->getBuiltinID() != 0 && name.find("::") == std::string::npos) name = "std::" + name;
  const auto arg = [&](unsigned i) { return expression(c->getArg(i)); };
  const auto grouped = [&](unsigned i) {
    const std::string text = arg(i);
    return text.find(' ') == std::string::npos && text.front() != '-' ? text : "(" + text + ")";
  };
  const auto typed = [&](const std::string& text) {  // an int in GLSL, and in C++ whatever the library says
    const bool same = context_.hasSameUnqualifiedType(c->getType(), context_.IntTy);
    return (same ? "" : type_of(c->getType(), c->getBeginLoc()).text()) + "(" + text + ")";
  };
  if (c->getNumArgs() == 0) {
    const std::string value = constant(c);
    if (!value.empty()) return value;
  }
  const bool scalar_float = c->getNumArgs() > 0 && c->getType().getNonReferenceType()->isFloatingType();
  const std::string bare = name.substr(name.rfind(':') + 1);
  // GLSL leaves min, max and clamp of NaN open: comparisons say what std:: and glm:: do.
  if ((bare == "min" || bare == "max") && c->getNumArgs() == 2 && (scalar_float || name.rfind("std::", 0) == 0)) {
    if (!scalar_float) return bare + "(" + arg(0) + ", " + arg(1) + ")";
    const std::string a = grouped(0);
    const std::string b = grouped(1);
    return bare == "min" ? "(" + b + " < " + a + " ? " + b + " : " + a + ")"
                         : "(" + a + " < " + b + " ? " + b + " : " + a + ")";
  }
  if (name == "glm::min" || name == "glm::max" || name == "glm::clamp") {
    const std::string type = type_of(c->getType(), c->getBeginLoc()).text();
    if (type.rfind("vec", 0) == 0) {
      const auto part = [&](unsigned i) {
        return c->getArg(i)->getType().getNonReferenceType()->isFloatingType() ? type + "(" + arg(i) + ")" : arg(i);
      };
      const auto greater = [](const std::string& a, const std::string& b) {
        return "mix(" + a + ", " + b + ", lessThan(" + a + ", " + b + "))";
      };
      const auto lesser = [](const std::string& a, const std::string& b) {
        return "mix(" + a + ", " + b + ", lessThan(" + b + ", " + a + "))";
      };
      if (name == "glm::min") return lesser(part(0), part(1));
      return name == "glm::max" ? greater(part(0), part(1)) : lesser(greater(part(0), part(1)), part(2));
    }
  }
  if (bare == "clamp" && c->getNumArgs() == 3) {
    if (!scalar_float) return "clamp(" + arg(0) + ", " + arg(1) + ", " + arg(2) + ")";
    const std::string x = grouped(0);
    return "(" + x + " < " + grouped(1) + " ? " + grouped(1) + " : (" + grouped(2) + " < " + x + " ? " + grouped(2) +
           " : " + x + "))";
  }
  if (name == "std::swap") {
    const std::string type = type_of(c->getArg(0)->getType(), c->getBeginLoc()).declare("pelage_first");
    return "{\nconst " + type + " = " + arg(0) + ";\n" + arg(0) + " = " + arg(1) + ";\n" + arg(1) +
           " = pelage_first;\n}";
  }
  if (name == "std::bit_cast") {
    const std::string to = type_of(c->getType(), c->getBeginLoc()).text();
    const std::string from = type_of(c->getArg(0)->getType(), c->getBeginLoc()).text();
    if (from == "float" && to == "uint") return "floatBitsToUint(" + arg(0) + ")";
    if (from == "float" && to == "int") return "floatBitsToInt(" + arg(0) + ")";
    if (from == "uint" && to == "float") return "uintBitsToFloat(" + arg(0) + ")";
    if (from == "int" && to == "float") return "intBitsToFloat(" + arg(0) + ")";
    const std::string integers = "int uint";
    if (integers.find(from) != std::string::npos && integers.find(to) != std::string::npos)
      return to + "(" + arg(0) + ")";
    return reject(c->getBeginLoc(), "std::bit_cast from " + from + " to " + to);
  }
  const bool bits =
      name == "std::countl_zero" || name == "std::countr_zero" || name == "std::bit_width" || name == "std::popcount";
  if (bits && context_.getTypeSize(c->getArg(0)->getType()) != 32) {
    return reject(c->getBeginLoc(), name + " of other than 32 bits");
  }
  if (name == "std::countl_zero") return typed("31 - findMSB(" + arg(0) + ")");
  if (name == "std::bit_width") return typed("findMSB(" + arg(0) + ") + 1");
  if (name == "std::countr_zero") return typed(grouped(0) + " == 0u ? 32 : findLSB(" + arg(0) + ")");
  if (name == "std::atomic_thread_fence") return "PELAGE_FENCE()";
  if (bare == "round") return reject(c->getBeginLoc(), "round: GLSL leaves halves open");
  const std::string same = builtin_function(name);
  if (same.empty()) return reject(c->getBeginLoc(), name + " has no GLSL form here");
  std::string text;
  for (unsigned i = 0; i < c->getNumArgs(); ++i)
    text += (i == 0 ? "" : ", ") + arg(i);
  arithmetic_ = arithmetic_ || has_float(c->getType());
  return same + "(" + text + ")";
}

std::string translator::operator_call(const CXXOperatorCallExpr* c, position at) {
  const OverloadedOperatorKind op = c->getOperator();
  const FunctionDecl* f = c->getDirectCallee();
  const QualType left = c->getArg(0)->getType();
  if (op == OO_Subscript && (is_array_type(left) || (f != nullptr && is_glm(f)))) {
    // The index is a size_t in C++; its own type will do here.
    return expression(c->getArg(0)) + "[" + expression(without_conversions(c->getArg(1))) + "]";
  }
  if (op == OO_Call) return reject(c->getBeginLoc(), "call through a pointer or of a callable object");
  const bool assigns = c->isAssignmentOp();
  const auto* method = dyn_cast_or_null<CXXMethodDecl>(f);
  const bool copies = op == OO_Equal && method != nullptr && !method->isUserProvided();
  if (f == nullptr || !(is_glm(f) || copies)) {
    // An operator of ours is a function by another name, as long as it changes nothing.
    if (f == nullptr || method != nullptr || operator_name(f).empty()) {
      return reject(c->getOperatorLoc(), "operator overload: call a function instead");
    }
    return call(c, at);
  }
  if (assigns && at == position::part) {
    return reject(c->getOperatorLoc(), "assignment inside an expression: make it a statement of its own");
  }
  if (op == OO_PlusPlus || op == OO_MinusMinus) return reject(c->getOperatorLoc(), "increment of a vector");
  arithmetic_ = arithmetic_ || is_glm(f);
  const std::string spelled = getOperatorSpelling(op);
  if (c->getNumArgs() == 1) return spelled + expression(c->getArg(0));
  return expression(c->getArg(0)) + " " + spelled + " " +
         expression(c->getArg(1), assigns ? position::whole : position::part);
}

std::string translator::construct(const CXXConstructExpr* c) {
  const CXXConstructorDecl* made = c->getConstructor();
  const bool vector = is_glm(made);
  if (made->isCopyOrMoveConstructor() && c->getNumArgs() == 1) return expression(c->getArg(0));
  if (vector) {
    if (c->getNumArgs() == 0) return reject(c->getBeginLoc(), "vector without a value");
    std::string text;
    for (const Expr* a : c->arguments())
      text += (text.empty() ? "" : ", ") + expression(a);
    return type_of(c->getType(), c->getBeginLoc()).text() + "(" + text + ")";
  }
  if (c->getNumArgs() == 0 && made->isTrivial()) return zero(c->getType(), c->getBeginLoc());
  if (c->getNumArgs() == 0 && !made->isUserProvided()) return zero(c->getType(), c->getBeginLoc());
  return reject(c->getBeginLoc(), "constructor of " + made->getParent()->getQualifiedNameAsString() +
                                      ": only aggregates are in the subset");
}

}  // namespace pelage::codegen
