// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Cells that the shader provides, atomics on them, what std::memory_order is to the mirror, and the subgroup.
#include "names.hpp"
#include "translator.hpp"

namespace pelage::codegen {

using namespace clang;

/// The macro by which the shader says where a span's element or a pointer's target lies, or how long a span is.
std::string translator::cell_macro(const Expr* e, const std::string& suffix, const std::string& parameter) {
  const auto* m = dyn_cast<MemberExpr>(e->IgnoreParenImpCasts());
  const auto* f = m == nullptr ? nullptr : dyn_cast<FieldDecl>(m->getMemberDecl());
  if (f == nullptr || !in_storage_) {
    return reject(e, "spans and pointers can only be members of storage, reached by its functions");
  }
  const std::string name = llvm::StringRef(global_name(f)).upper() + suffix;
  fresh_->where->cells[name] = {name + parameter, suffix.empty() ? doc_of(f, true) : "///< how many of them",
                                qualified_name(f->getParent())};
  return name;
}

/// x in static_cast<std::uint32_t>(x.size()), x a span; else null.
const Expr* translator::counted_span(const CastExpr* c) const {
  const auto* call = dyn_cast<CXXMemberCallExpr>(c->getSubExpr()->IgnoreParenImpCasts());
  if (call == nullptr || !isa<ExplicitCastExpr>(c) || context_.getTypeSize(c->getType()) != 32) return nullptr;
  const Expr* object = call->getImplicitObjectArgument();
  return is_std_type(object->getType(), "span") && call->getMethodDecl()->getName() == "size" ? object : nullptr;
}

/// One operation of std::atomic_ref. The value passes through pelage_release() on its way in and pelage_acquire() on
/// its way out; both are fences of the given order, and left out where the order is relaxed for good.
std::string translator::atomic(const CallExpr* c, const Expr* reference, const std::string& name, unsigned first,
                               position at) {
  const auto* made = dyn_cast<CXXConstructExpr>(reference->IgnoreParenCasts());
  const Expr* place = made != nullptr && made->getNumArgs() == 1 ? made->getArg(0) : nullptr;
  if (place == nullptr) return reject(c, "atomics: write std::atomic_ref(cell).operation(...)");
  const std::string target = glsl(place);
  const bool wide = context_.getTypeSize(place->getType()) == 64;
  fresh_->where->memory_orders.insert(memory_order_path);
  if (wide) fresh_->where->memory_orders.insert(memory_order_64_path);
  fresh_->where->uses_int64 |= wide;
  const auto arg = [&](unsigned i) { return glsl(c->getArg(first + i)); };
  const auto fenced = [](const char* fence, const std::string& value, const std::string& order) {
    return order == "pelage_memory_order_relaxed" ? value : filled("{0}({1}, {2})", fence, value, order);
  };
  if (name == "load") return fenced("pelage_acquire", wide ? "PELAGE_LOAD_64(" + target + ")" : target, arg(0));
  if (at == position::part) return reject(c, effect_inside);
  if (name == "store") return filled("atomicExchange({0}, {1})", target, fenced("pelage_release", arg(0), arg(1)));
  if (name == "compare_exchange_strong") {
    // It leaves in `expected` what it found, taken or not: the same as assigning the result.
    if (at != position::statement) return reject(c, "result of compare_exchange_strong: compare `expected`");
    const std::string value = fenced("pelage_release", arg(1), arg(2));
    const std::string found = filled("atomicCompSwap({0}, {1}, {2})", target, arg(0), value);
    return arg(0) + " = " + fenced("pelage_acquire", found, arg(2));
  }
  const auto* operation = llvm::StringSwitch<const char*>(name)
                              .Case("exchange", "atomicExchange")
                              .Case("fetch_add", "atomicAdd")
                              .Case("fetch_and", "atomicAnd")
                              .Case("fetch_or", "atomicOr")
                              .Case("fetch_xor", "atomicXor")
                              .Case("fetch_min", "atomicMin")
                              .Case("fetch_max", "atomicMax")
                              .Default(nullptr);
  if (operation == nullptr) return reject(c, "std::atomic_ref::" + name + " has no GLSL form");
  const std::string value = fenced("pelage_release", arg(0), arg(1));
  return fenced("pelage_acquire", filled("{0}({1}, {2})", operation, target, value), arg(1));
}

/// What a function of pelage::subgroup does: in C++ the group is one lane, so its body is not what GLSL needs. {0} and
/// {1} are the parameters.
std::string translator::subgroup_body(const FunctionDecl* f) {
  const auto* method = dyn_cast<CXXMethodDecl>(f);
  if (method == nullptr || method->getParent()->getQualifiedNameAsString() != "pelage::subgroup") return {};
  const auto* text = llvm::StringSwitch<const char*>(f->getName())
                         .Case("size", "return PELAGE_SUBGROUP_SIZE;")
                         .Case("lane", "return gl_SubgroupInvocationID;")
                         .Case("shuffle", "return subgroupShuffle({0}, {1});")
                         .Case("shuffle_xor", "return subgroupShuffleXor({0}, {1});")
                         .Case("count",
                               "const uvec4 pelage_set = subgroupBallot({0});\nreturn pelage_lane_count("
                               "subgroupBallotBitCount(pelage_set), subgroupBallotExclusiveBitCount(pelage_set));")
                         .Case("barrier", "subgroupBarrier();")
                         .Default(nullptr);
  if (text == nullptr) return {};  // its words are cells as any
  fresh_->where->uses_subgroup = true;
  const auto name = [&](unsigned i) { return i < f->getNumParams() ? renamed_[f->getParamDecl(i)] : std::string(); };
  return "{\n" + filled(text, name(0), name(1)) + "\n}";
}

namespace {

constexpr const char* memory_order_32 = R"(// Generated by pelage-glsl: what std::memory_order is to the mirror.
#ifndef PELAGE_CORE_MEMORY_ORDER_GLSL
#define PELAGE_CORE_MEMORY_ORDER_GLSL

// The fence behind an acquire and before a release. A shader may define its own before it includes this file: Mesa's
// lavapipe, at least up to 22.3, loses invocations at a barrier in a loop when a workgroup is larger than a subgroup.
#ifndef PELAGE_FENCE
#define PELAGE_FENCE() memoryBarrierBuffer()
#endif

const int pelage_memory_order_relaxed = 0;
const int pelage_memory_order_consume = 1;
const int pelage_memory_order_acquire = 2;
const int pelage_memory_order_release = 3;
const int pelage_memory_order_acq_rel = 4;
const int pelage_memory_order_seq_cst = 5;

/// A value that was loaded: what comes after stays after it, if the order says so.
uint pelage_acquire(uint value, int order) {
  if (order != pelage_memory_order_relaxed && order != pelage_memory_order_release) {
    PELAGE_FENCE();
  }
  return value;
}

/// A value on its way to memory: what came before stays before it, if the order says so.
uint pelage_release(uint value, int order) {
  if (order >= pelage_memory_order_release) {
    PELAGE_FENCE();
  }
  return value;
}

#endif
)";

constexpr const char* memory_order_64 = R"(// Generated by pelage-glsl: memory_order.glsl for cells of 64 bits.
#ifndef PELAGE_CORE_MEMORY_ORDER_64_GLSL
#define PELAGE_CORE_MEMORY_ORDER_64_GLSL

#include "memory_order.glsl"

// The load of a cell. A shader for hardware that loads 64 bits in two parts may define it before it includes this
// file, as atomicOr(cell, 0ul).
#ifndef PELAGE_LOAD_64
#define PELAGE_LOAD_64(cell) cell
#endif

/// As pelage_acquire() of a uint.
uint64_t pelage_acquire(uint64_t value, int order) {
  pelage_acquire(0u, order);
  return value;
}

/// As pelage_release() of a uint.
uint64_t pelage_release(uint64_t value, int order) {
  pelage_release(0u, order);
  return value;
}

#endif
)";

}  // namespace

std::string memory_order_text(const std::string& path) {
  return std::string(licence) + (path == memory_order_path ? memory_order_32 : memory_order_64);
}

}  // namespace pelage::codegen
