// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "names.hpp"
#include "translator.hpp"

namespace pelage::codegen {

using namespace clang;

namespace {

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
    text = isa<CXXThisExpr>(object->IgnoreParenImpCasts()) ? "self" : glsl(object);
    places.emplace_back(text, writes);
    effects = writes;
  }
  for (std::size_t i = 0; i < args.size(); ++i) {
    const QualType parameter = f->getParamDecl(static_cast<unsigned>(i))->getType();
    if (is_storage_type(parameter)) {
      effects = effects || writes_to(parameter);
      continue;
    }
    const std::string one = glsl(args[i]);
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

std::string translator::operator_call(const CXXOperatorCallExpr* c, position at) {
  const OverloadedOperatorKind op = c->getOperator();
  const FunctionDecl* f = c->getDirectCallee();
  const QualType left = c->getArg(0)->getType();
  if (op == OO_Subscript && (is_array_type(left) || (f != nullptr && is_glm(f)))) {
    // The index is a size_t in C++; its own type will do here.
    return glsl(c->getArg(0)) + "[" + glsl(without_conversions(c->getArg(1))) + "]";
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
  if (c->getNumArgs() == 1) return spelled + glsl(c->getArg(0));
  return glsl(c->getArg(0)) + " " + spelled + " " +
         glsl(c->getArg(1), assigns ? position::whole : position::part);
}

std::string translator::construct(const CXXConstructExpr* c) {
  const CXXConstructorDecl* made = c->getConstructor();
  const bool vector = is_glm(made);
  if (made->isCopyOrMoveConstructor() && c->getNumArgs() == 1) return glsl(c->getArg(0));
  if (vector) {
    if (c->getNumArgs() == 0) return reject(c->getBeginLoc(), "vector without a value");
    const std::vector<const Expr*> values(c->arg_begin(), c->arg_end());
    return type_of(c->getType(), c->getBeginLoc()).text() + "(" + listed(values) + ")";
  }
  if (c->getNumArgs() == 0 && (made->isTrivial() || !made->isUserProvided()))
    return zero(c->getType(), c->getBeginLoc());
  return reject(c->getBeginLoc(), "constructor of " + made->getParent()->getQualifiedNameAsString() +
                                      ": only aggregates are in the subset");
}

}  // namespace pelage::codegen
