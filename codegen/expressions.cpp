// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "names.hpp"
#include "translator.hpp"

namespace pelage::codegen {

using namespace clang;

bool has_size(const Stmt* s) {
  if (isa<SubstNonTypeTemplateParmExpr>(s)) return true;
  return std::any_of(s->child_begin(), s->child_end(), [](const Stmt* c) { return c != nullptr && has_size(c); });
}

namespace {

constexpr CastKind vanishing[] = {CK_LValueToRValue, CK_NoOp, CK_FunctionToPointerDecay, CK_ConstructorConversion,
                                  CK_UserDefinedConversion};
constexpr CastKind numeric[] = {CK_IntegralCast, CK_IntegralToFloating, CK_FloatingToIntegral,
                                CK_FloatingCast, CK_IntegralToBoolean,  CK_FloatingToBoolean};

/// What lies within copies and within lists of one value.
const Expr* copied(const Expr* e) {
  e = e->IgnoreImplicit();
  const auto* made = dyn_cast<CXXConstructExpr>(e);
  if (made != nullptr && made->getNumArgs() == 1 && made->getConstructor()->isCopyOrMoveConstructor()) {
    return copied(made->getArg(0));
  }
  const auto* list = dyn_cast<InitListExpr>(e);
  return list != nullptr && list->getNumInits() == 1 && list->getType()->isScalarType() ? copied(list->getInit(0)) : e;
}

}  // namespace

std::string kept(const Expr* e, const std::string& value) {
  const auto* cast = dyn_cast<ExplicitCastExpr>(e);
  if (cast == nullptr && !isa<CXXTemporaryObjectExpr>(e)) return value;
  const Expr* whole = cast == nullptr ? e : cast->getSubExpr();
  const Expr* from = copied(whole);
  const auto* op = dyn_cast<CXXOperatorCallExpr>(from);
  const bool loose = isa<BinaryOperator, ConditionalOperator>(from) || (op != nullptr && op->isInfixBinaryOp());
  const auto plain = [](const Expr* x) { return x->getType().getCanonicalType().getUnqualifiedType(); };
  return loose && plain(from) == plain(whole) ? "(" + value + ")" : value;
}

std::string translator::unary(const UnaryOperator* x, position at) {
  const Expr* operand = x->getSubExpr();
  const std::string op = UnaryOperator::getOpcodeStr(x->getOpcode()).str();
  if (x->isIncrementDecrementOp()) {
    if (at != position::statement) {
      return reject(x->getOperatorLoc(), "increment inside an expression: make it a statement of its own");
    }
    return x->isPrefix() ? op + glsl(operand) : glsl(operand) + op;
  }
  if (x->getOpcode() == UO_Deref && isa<CXXThisExpr>(operand->IgnoreParenImpCasts())) return "self";
  if (x->getOpcode() == UO_Deref && isa<MemberExpr>(operand->IgnoreParenImpCasts())) return cell_macro(operand, "", "");
  if (x->getOpcode() == UO_Deref || x->getOpcode() == UO_AddrOf) return reject(x->getOperatorLoc(), "pointer");
  arithmetic_ = arithmetic_ || x->getType()->isFloatingType();
  return prefixed(op, glsl(operand));
}

std::string translator::binary(const BinaryOperator* x, position at) {
  const BinaryOperatorKind op = x->getOpcode();
  if (x->isAssignmentOp() && at != position::statement) return reject(x->getOperatorLoc(), assignment_inside);
  if (op == BO_Comma) return reject(x->getOperatorLoc(), "comma operator");
  if (op == BO_Cmp) return reject(x->getOperatorLoc(), "operator <=>");
  if (x->isPtrMemOp()) return reject(x->getOperatorLoc(), "pointer to member");
  if ((op == BO_Rem || op == BO_RemAssign) && x->getLHS()->getType()->isSignedIntegerType()) {
    return reject(x->getOperatorLoc(), "% on signed integers");
  }
  if (const auto* c = dyn_cast<CompoundAssignOperator>(x);
      c != nullptr && !context_.hasSameUnqualifiedType(c->getComputationResultType(), c->getLHS()->getType())) {
    return reject(x, "compound assignment that converts: write the conversion out");
  }
  arithmetic_ = arithmetic_ || (x->getType()->isFloatingType() && !x->isComparisonOp() && op != BO_Assign);
  if (const std::string value = rounded(x); !value.empty()) return value;
  const position right = x->isAssignmentOp() ? position::whole : position::part;
  return glsl(x->getLHS()) + " " + x->getOpcodeStr().str() + " " + glsl(x->getRHS(), right);
}

std::string translator::conversion(const CastExpr* c, position at) {
  const Expr* from = c->getSubExpr();
  const SourceLocation where = c->getBeginLoc();
  if (c->getType()->isVoidType()) {
    const Expr* dropped = from->IgnoreParenCasts();
    return dropped->HasSideEffects(context_) ? glsl(dropped, at) : std::string();
  }
  if (isa<CStyleCastExpr>(c)) return reject(where, "C cast: use static_cast or T(x)");
  if (isa<CXXReinterpretCastExpr, CXXConstCastExpr, CXXDynamicCastExpr>(c)) {
    return reject(where, "reinterpret_cast, const_cast and dynamic_cast");
  }
  const auto* spelled = dyn_cast<ExplicitCastExpr>(c);
  const QualType to = spelled == nullptr ? c->getType() : spelled->getTypeAsWritten();
  if (const Expr* span = counted_span(c)) return type_of(to, where) + "(" + cell_macro(span, "_SIZE", "") + ")";
  const CastKind kind = c->getCastKind();
  if (llvm::is_contained(vanishing, kind)) return kept(c, glsl(from, at));
  if (!llvm::is_contained(numeric, kind)) {
    return reject(where, std::string("conversion ") + c->getCastKindName() + " is not in the subset");
  }
  if (kind == CK_FloatingCast) {
    const auto* l = dyn_cast<FloatingLiteral>(from->IgnoreParenImpCasts());
    const std::string value = l == nullptr ? constant(from) : literal(l);
    const bool to_float = context_.hasSameUnqualifiedType(to, context_.FloatTy) && !value.empty();
    return to_float ? value : reject(where, "double: the mirror computes in float");
  }
  const Expr* plain = from->IgnoreParens();
  if (const auto* l = dyn_cast<IntegerLiteral>(plain)) return literal(l, c->getType());
  if (const auto* u = dyn_cast<UnaryOperator>(plain); u != nullptr && u->getOpcode() == UO_Minus) {
    const auto* l = dyn_cast<IntegerLiteral>(u->getSubExpr());
    if (l != nullptr && !c->getType()->isUnsignedIntegerType()) return "-" + literal(l, c->getType());
  }
  const QualType was = from->getType();
  if (context_.hasSameUnqualifiedType(to, was)) return kept(c, glsl(from, at));
  const bool widens = to->isIntegerType() && context_.getTypeSize(to) == 64 && context_.getTypeSize(was) < 64;
  if (widens && spelled == nullptr && !cast<ImplicitCastExpr>(c)->isPartOfExplicitCast()) {
    return reject(where, "widened to 64 bits where that is not declared: write static_cast<std::uint64_t>");
  }
  const std::string text = glsl(from, at);
  const std::string target = type_of(to, where);
  // An enumeration is its number in GLSL: nothing to convert between the two, unless the widths differ.
  const auto* e = was->getAs<EnumType>();
  const bool same = e != nullptr && target == scalar_type(e->getDecl()->getIntegerType(), where);
  return same ? kept(c, text) : target + "(" + text + ")";
}

std::string translator::reference(const DeclRefExpr* r) {
  const ValueDecl* d = r->getDecl();
  if (const auto found = renamed_.find(d); found != renamed_.end()) return found->second;
  if (const auto* e = dyn_cast<EnumConstantDecl>(d)) {
    const auto* owner = cast<EnumDecl>(e->getDeclContext());
    if (owner->isInStdNamespace()) return "pelage_" + owner->getNameAsString() + "_" + e->getNameAsString();
    return use(owner, r->getBeginLoc()) + "_" + e->getNameAsString();
  }
  const auto* v = dyn_cast<VarDecl>(d);
  if (isa<BindingDecl>(d) || (v != nullptr && v->isStaticLocal())) return d->getNameAsString();  // told already
  if (v == nullptr) return reject(r, "`" + d->getNameAsString() + "` is not in the subset");
  if (is_storage(v->getType())) return reject(r, "storage can only be passed on whole, or called");
  if (!v->hasGlobalStorage()) return v->getNameAsString();
  if (!v->isConstexpr()) return reject(r, "global variable `" + v->getNameAsString() + "` that is not constexpr");
  if (v->isInStdNamespace()) {
    if (v->getType()->isEnumeralType()) return "pelage_" + v->getNameAsString();  // std::memory_order_relaxed
    return constant(r);
  }
  return use(v, r->getBeginLoc());
}

std::string translator::member(const MemberExpr* m) {
  const ValueDecl* d = m->getMemberDecl();
  if (const auto* v = dyn_cast<VarDecl>(d)) {
    if (!v->isConstexpr()) return reject(m, "static data member that is not constexpr");
    return use(v, m->getBeginLoc());
  }
  const auto* f = dyn_cast<FieldDecl>(d);
  if (f == nullptr) return reject(m, "`" + d->getNameAsString() + "` is not in the subset");
  const Expr* base = m->getBase();
  if (f->isAnonymousStructOrUnion()) return glsl(base);  // glm's v.x lies in one
  std::string text = isa<CXXThisExpr>(base->IgnoreParenImpCasts()) ? "self" : glsl(base);
  if (m->isArrow() && text != "self") return reject(m->getOperatorLoc(), "pointer");
  if (isa<ConditionalOperator>(base->IgnoreParenImpCasts()) && text.front() != '(') text = "(" + text + ")";
  return text + "." + f->getNameAsString();
}

}  // namespace pelage::codegen
