// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "names.hpp"
#include "translator.hpp"

namespace pelage::codegen {

using namespace clang;

namespace {

bool is_std_type(QualType t, llvm::StringRef name) {
  const CXXRecordDecl* r = t.getNonReferenceType()->getAsCXXRecordDecl();
  return r != nullptr && r->isInStdNamespace() && r->getName() == name;
}

/// x in std::atomic_ref(x).
const Expr* referred(const Expr* e) {
  for (;;) {
    e = e->IgnoreParenImpCasts();
    if (const auto* m = dyn_cast<MaterializeTemporaryExpr>(e)) {
      e = m->getSubExpr();
    } else if (const auto* b = dyn_cast<CXXBindTemporaryExpr>(e)) {
      e = b->getSubExpr();
    } else if (const auto* c = dyn_cast<ExplicitCastExpr>(e)) {
      e = c->getSubExpr();
    } else {
      const auto* made = dyn_cast<CXXConstructExpr>(e);
      return made != nullptr && made->getNumArgs() == 1 ? made->getArg(0) : nullptr;
    }
  }
}

}  // namespace

/// The macro by which the shader says where a span's element or a pointer's target lies.
std::string translator::cell_name(const Expr* e, const std::string& index) {
  const auto* m = dyn_cast<MemberExpr>(e->IgnoreParenImpCasts());
  const auto* f = m == nullptr ? nullptr : dyn_cast<FieldDecl>(m->getMemberDecl());
  if (f == nullptr || !in_storage_) {
    return reject(e->getBeginLoc(), "spans and pointers can only be members of storage, reached by its functions");
  }
  const std::string name = upper(global_name(f->getParent()) + "_" + f->getNameAsString());
  fresh_->where->cells[name] = {index.empty() ? name : name + "(i)", doc_beside(f->getLocation())};
  return index.empty() ? name : name + "(" + index + ")";
}

/// What only storage holds: cells, their number, and atomics on them. False for anything else.
bool translator::storage_expression(const Expr* e, std::string& text, position at) {
  if (const auto* c = dyn_cast<CXXMemberCallExpr>(e)) {
    const QualType object = c->getImplicitObjectArgument()->getType();
    if (is_std_type(object, "__atomic_ref") || is_std_type(object, "atomic_ref") ||
        c->getMethodDecl()->getQualifiedNameAsString().rfind("std::__atomic_ref", 0) == 0) {
      text = atomic(c, c->getImplicitObjectArgument(), c->getMethodDecl()->getNameAsString(), 0, at);
      return true;
    }
    if (is_std_type(object, "span")) {
      text = reject(e->getBeginLoc(), "a span's size is a size_t: write static_cast<std::uint32_t>(x.size())");
      return true;
    }
    return false;
  }
  if (const auto* c = dyn_cast<CallExpr>(e); c != nullptr && c->getDirectCallee() != nullptr) {
    // std::atomic_ref has no minimum before C++26: the library's own stands for GLSL's.
    const std::string name = c->getDirectCallee()->getQualifiedNameAsString();
    if (name == "pelage::fetch_minimum") {
      text = atomic(c, c->getArg(0), "fetch_min", 1, at);
      return true;
    }
  }
  if (const auto* c = dyn_cast<ExplicitCastExpr>(e)) {
    const auto* call = dyn_cast<CXXMemberCallExpr>(c->getSubExpr()->IgnoreParenImpCasts());
    const bool counts = call != nullptr && is_std_type(call->getImplicitObjectArgument()->getType(), "span") &&
                        call->getMethodDecl()->getName() == "size" && context_.getTypeSize(c->getType()) == 32;
    if (!counts) return false;
    const std::string cells = cell_name(call->getImplicitObjectArgument(), "");
    if (!in_storage_) return true;
    cell& described = fresh_->where->cells[cells];
    const std::string doc = described.doc;
    fresh_->where->cells.erase(cells);
    fresh_->where->cells[cells + "_SIZE"] = {cells + "_SIZE", "///< how many of them"};
    if (fresh_->where->cells.count(cells) == 0) fresh_->where->cells[cells] = {cells + "(i)", doc};
    text = type_of(c->getTypeAsWritten(), c->getBeginLoc()).text() + "(" + cells + "_SIZE)";
    return true;
  }
  if (const auto* c = dyn_cast<CXXOperatorCallExpr>(e)) {
    if (c->getOperator() != OO_Subscript || !is_std_type(c->getArg(0)->getType(), "span")) return false;
    text = cell_name(c->getArg(0), glsl(without_conversions(c->getArg(1))));
    return true;
  }
  if (const auto* u = dyn_cast<UnaryOperator>(e)) {
    const auto* m = dyn_cast<MemberExpr>(u->getSubExpr()->IgnoreParenImpCasts());
    if (u->getOpcode() != UO_Deref || m == nullptr) return false;
    text = cell_name(m, "");
    return true;
  }
  return false;
}

/// One operation of std::atomic_ref. The value passes through pelage_release() on its way in and pelage_acquire() on
/// its way out; both are fences of the given order, and left out where the order is relaxed for good.
std::string translator::atomic(const CallExpr* c, const Expr* reference, const std::string& name, unsigned first,
                               position at) {
  const Expr* place = referred(reference);
  if (place == nullptr) return reject(c->getBeginLoc(), "atomics: write std::atomic_ref(cell).operation(...)");
  const std::string target = glsl(place);
  fresh_->where->uses_atomics = true;
  const bool wide = context_.getTypeSize(place->getType()) == 64;
  fresh_->where->uses_int64 |= wide;
  fresh_->where->uses_atomic_int64 |= wide;
  const bool writes = name != "load";
  if (writes && at == position::part) {
    return reject(c->getBeginLoc(), "call with an effect inside an expression: give its result a name first");
  }
  const auto arg = [&](unsigned i) { return glsl(c->getArg(first + i)); };
  const auto release = [&](const std::string& value, const std::string& order) {
    return order == "pelage_memory_order_relaxed" ? value : "pelage_release(" + value + ", " + order + ")";
  };
  const auto acquire = [&](const std::string& value, const std::string& order) {
    return order == "pelage_memory_order_relaxed" ? value : "pelage_acquire(" + value + ", " + order + ")";
  };
  if (name == "load") return acquire(wide ? "PELAGE_LOAD_64(" + target + ")" : target, arg(0));
  if (name == "store") return "atomicExchange(" + target + ", " + release(arg(0), arg(1)) + ")";
  if (name == "compare_exchange_strong") {
    // It leaves in `expected` what it found, taken or not: the same as assigning the result.
    return arg(0) + " = " +
           acquire("atomicCompSwap(" + target + ", " + arg(0) + ", " + release(arg(1), arg(2)) + ")", arg(2));
  }
  static const std::map<std::string, std::string> same = {{"exchange", "atomicExchange"}, {"fetch_add", "atomicAdd"},
                                                          {"fetch_and", "atomicAnd"},     {"fetch_or", "atomicOr"},
                                                          {"fetch_xor", "atomicXor"},     {"fetch_min", "atomicMin"}};
  const auto found = same.find(name);
  if (found == same.end()) return reject(c->getBeginLoc(), "std::atomic_ref::" + name + " has no GLSL form");
  return acquire(found->second + "(" + target + ", " + release(arg(0), arg(1)) + ")", arg(1));
}

}  // namespace pelage::codegen
