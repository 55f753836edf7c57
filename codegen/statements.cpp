// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "names.hpp"
#include "translator.hpp"

#include <algorithm>

namespace pelage::codegen {

using namespace clang;

/// Statements one after another, with the comments and blank lines between them.
std::string translator::sequence(Stmt::const_child_range statements, SourceLocation end) {
  std::string text;
  unsigned last_line = 0;
  for (const Stmt* s : statements) {
    if (s == nullptr) continue;
    text += comments_before(offset(s->getBeginLoc()), last_line);
    if (last_line != 0 && line(s->getBeginLoc()) > last_line + 1) text += "\n";
    std::string one = statement(s);
    last_line = line(s->getEndLoc());
    const std::string beside = comment_beside(s->getEndLoc());
    if (!one.empty()) text += one + beside + "\n";
  }
  text += comments_before(offset(end), last_line);
  return text;
}

std::string translator::block(const Stmt* s) {
  if (const auto* compound = dyn_cast<CompoundStmt>(s)) {
    const auto* only = compound->size() == 1 ? dyn_cast<IfStmt>(compound->body_front()) : nullptr;
    if (only != nullptr && only->isConstexpr()) {
      const Stmt* branch = taken_branch(only);
      if (branch != nullptr) return block(branch);  // in the place of the block round it
    }
    const std::string beside = comment_beside(compound->getLBracLoc());
    return "{" + beside + "\n" + sequence(compound->children(), compound->getRBracLoc()) + "}";
  }
  return "{\n" + statement(s) + comment_beside(s->getEndLoc()) + "\n}";
}

/// The branch of an `if constexpr`, null for none. The comments of the other one go with it.
const Stmt* translator::taken_branch(const IfStmt* s) {
  if (has_size(s->getCond())) {
    reject(s->getBeginLoc(), "`if constexpr` over a size: the size is lost, use a plain `if`");
    return nullptr;
  }
  bool taken = false;
  (void)s->getCond()->EvaluateAsBooleanCondition(taken, context_);
  if (const Stmt* other = taken ? s->getElse() : s->getThen()) {
    const unsigned begin = offset(other->getBeginLoc());
    const unsigned end = offset(other->getEndLoc());
    const auto inside = [&](const comment& c) { return c.offset >= begin && c.offset < end; };
    comments_.erase(
        std::remove_if(comments_.begin() + static_cast<std::ptrdiff_t>(next_comment_), comments_.end(), inside),
        comments_.end());
  }
  return taken ? s->getThen() : s->getElse();
}

std::string translator::statement(const Stmt* s) {
  if (isa<NullStmt>(s)) return {};
  if (isa<CompoundStmt>(s)) return block(s);
  if (const auto* e = dyn_cast<Expr>(s)) {
    const std::string text = effect(e);
    return text.empty() || text.back() == '}' ? text : text + ";";
  }
  if (const auto* d = dyn_cast<DeclStmt>(s)) return variables(d);
  if (const auto* r = dyn_cast<ReturnStmt>(s)) {
    return r->getRetValue() == nullptr ? "return;" : "return " + expression(r->getRetValue(), position::whole) + ";";
  }
  if (const auto* i = dyn_cast<IfStmt>(s)) {
    if (i->hasInitStorage() || i->hasVarStorage()) return reject(s->getBeginLoc(), "declaration inside `if`");
    if (i->isConstexpr()) {
      const Stmt* branch = taken_branch(i);
      return branch == nullptr ? std::string() : statement(branch);
    }
    std::string text = "if (" + expression(i->getCond(), position::whole) + ") " + block(i->getThen());
    if (const Stmt* other = i->getElse()) text += " else " + (isa<IfStmt>(other) ? statement(other) : block(other));
    return text;
  }
  if (const auto* f = dyn_cast<ForStmt>(s)) return for_loop(f);
  if (const auto* f = dyn_cast<CXXForRangeStmt>(s)) return range_loop(f);
  if (const auto* w = dyn_cast<WhileStmt>(s)) {
    if (w->hasVarStorage()) return reject(s->getBeginLoc(), "declaration inside `while`");
    return "while (" + expression(w->getCond(), position::whole) + ") " + block(w->getBody());
  }
  if (const auto* d = dyn_cast<DoStmt>(s)) {
    const std::string body = block(d->getBody());
    return "do " + body + " while (" + expression(d->getCond(), position::whole) + ");";
  }
  if (const auto* w = dyn_cast<SwitchStmt>(s)) return switch_statement(w);
  if (isa<BreakStmt>(s)) return "break;";
  if (isa<ContinueStmt>(s)) return "continue;";
  if (isa<GotoStmt>(s) || isa<LabelStmt>(s)) return reject(s->getBeginLoc(), "goto and labels");
  if (isa<CXXTryStmt>(s)) return reject(s->getBeginLoc(), "exceptions");
  if (const auto* a = dyn_cast<AttributedStmt>(s)) return statement(a->getSubStmt());
  return reject(s->getBeginLoc(), std::string(s->getStmtClassName()) + " is not in the subset");
}

/// An expression for the sake of what it does: the only place of assignments and increments.
std::string translator::effect(const Expr* e) {
  e = e->IgnoreImplicit();
  if (const auto* p = dyn_cast<ParenExpr>(e)) return effect(p->getSubExpr());
  if (const auto* b = dyn_cast<BinaryOperator>(e); b != nullptr && b->isAssignmentOp()) {
    if (b->isCompoundAssignmentOp()) {
      const auto* compound = cast<CompoundAssignOperator>(b);
      if (!context_.hasSameUnqualifiedType(compound->getComputationResultType(), b->getLHS()->getType())) {
        return reject(e->getBeginLoc(), "compound assignment that converts: write the conversion out");
      }
      if (b->getOpcode() == BO_RemAssign && b->getLHS()->getType()->isSignedIntegerType()) {
        return reject(e->getBeginLoc(), "% on signed integers");
      }
      arithmetic_ = arithmetic_ || b->getType()->isFloatingType();
    }
    const std::string left = expression(b->getLHS());
    return left + " " + b->getOpcodeStr().str() + " " + expression(b->getRHS(), position::whole);
  }
  if (const auto* u = dyn_cast<UnaryOperator>(e); u != nullptr && u->isIncrementDecrementOp()) {
    const std::string op = u->isIncrementOp() ? "++" : "--";
    return u->isPrefix() ? op + expression(u->getSubExpr()) : expression(u->getSubExpr()) + op;
  }
  if (const auto* c = dyn_cast<ExplicitCastExpr>(e); c != nullptr && c->getType()->isVoidType()) {
    const Expr* dropped = c->getSubExpr()->IgnoreParenCasts();
    if (dropped->HasSideEffects(context_)) return expression(dropped, position::whole);
    return {};
  }
  if (isa<CallExpr>(e)) return expression(e, position::whole);
  if (isa<CXXThrowExpr>(e) || isa<CXXDeleteExpr>(e)) return unsupported(e);
  return reject(e->getBeginLoc(), "statement without effect");
}

std::string translator::for_loop(const ForStmt* s) {
  if (s->getConditionVariable() != nullptr) return reject(s->getBeginLoc(), "declaration inside a `for` condition");
  std::string init = ";";
  if (const auto* d = dyn_cast_or_null<DeclStmt>(s->getInit())) {
    init = variables(d);
  } else if (s->getInit() != nullptr) {
    init = effect(cast<Expr>(s->getInit())) + ";";
  }
  const std::string condition = s->getCond() == nullptr ? "" : " " + expression(s->getCond(), position::whole);
  const std::string step = s->getInc() == nullptr ? "" : " " + effect(s->getInc());
  return "for (" + init + condition + ";" + step + ") " + block(s->getBody());
}

/// for (T x : array): a loop over a counter that no other name can meet.
std::string translator::range_loop(const CXXForRangeStmt* s) {
  const VarDecl* v = s->getLoopVariable();
  const Expr* range = s->getRangeInit()->IgnoreParenImpCasts();
  QualType element;
  std::string extent;
  QualType range_type = range->getType();
  if (const auto* m = dyn_cast<MemberExpr>(range)) range_type = m->getMemberDecl()->getType();
  if (const auto* r = dyn_cast<DeclRefExpr>(range)) range_type = r->getDecl()->getType();
  if (!is_array(range_type.getNonReferenceType().getUnqualifiedType(), element, extent)) {
    return reject(range->getBeginLoc(), "range-for over something other than a std::array");
  }
  const std::string name = local_name(v);
  const std::string index = "pelage_" + name + "_index";
  const std::string item = expression(range) + "[" + index + "]";
  std::string first;
  if (writes_to(v->getType())) {
    renamed_[v] = item;
  } else {
    const bool constant = v->getType().isConstQualified();
    first = (constant ? "const " : "") + type_of(v->getType(), v->getLocation()).declare(name) + " = " + item + ";\n";
  }
  std::string body = block(s->getBody()).substr(1);
  if (body.front() == '\n') body.erase(0, 1);
  return "for (int " + index + " = 0; " + index + " < " + extent + "; ++" + index + ") {\n" + first + body;
}

std::string translator::switch_statement(const SwitchStmt* s) {
  if (s->hasInitStorage() || s->hasVarStorage()) return reject(s->getBeginLoc(), "declaration inside `switch`");
  const auto* body = dyn_cast<CompoundStmt>(s->getBody());
  if (body == nullptr) return reject(s->getBeginLoc(), "switch without a block");
  std::string text = "switch (" + expression(s->getCond()) + ") {\n";
  for (const Stmt* one : body->children()) {
    while (const auto* label = dyn_cast<SwitchCase>(one)) {
      unsigned last_line = 0;
      text += comments_before(offset(label->getBeginLoc()), last_line);
      if (const auto* c = dyn_cast<CaseStmt>(label)) {
        if (c->caseStmtIsGNURange()) return reject(c->getBeginLoc(), "range of cases");
        text += "case " + expression(c->getLHS()) + ":";
      } else {
        text += "default:";
      }
      one = label->getSubStmt();
      const bool alone = line(one->getBeginLoc()) > line(label->getColonLoc());
      text += (alone ? comment_beside(label->getColonLoc()) : "") + "\n";
    }
    text += statement(one) + comment_beside(one->getEndLoc()) + "\n";
  }
  return text + "}";
}

std::string translator::variables(const DeclStmt* s) {
  std::string text;
  for (const Decl* d : s->decls()) {
    if (const auto* check = dyn_cast<StaticAssertDecl>(d)) note_condition(check);
    if (isa<StaticAssertDecl>(d) || isa<TypedefNameDecl>(d) || isa<UsingDecl>(d) || isa<UsingDirectiveDecl>(d)) {
      continue;
    }
    const auto* v = dyn_cast<VarDecl>(d);
    if (v == nullptr || isa<DecompositionDecl>(d)) {
      text += reject(d->getBeginLoc(), isa<DecompositionDecl>(d) ? "structured binding" : "local type");
      continue;
    }
    text += (text.empty() ? "" : "\n") + variable(v) + ";";
  }
  return text;
}

/// const T& to a part of what no one can write to meanwhile: as good as a copy.
bool translator::names_constant(const VarDecl* v) {
  if (!v->getType().getNonReferenceType().isConstQualified() || v->getInit() == nullptr) return false;
  const Expr* e = v->getInit();
  for (;;) {
    e = e->IgnoreParenImpCasts();
    if (const auto* m = dyn_cast<MemberExpr>(e)) {
      e = m->getBase();
    } else if (const auto* c = dyn_cast<CXXOperatorCallExpr>(e); c != nullptr && c->getOperator() == OO_Subscript) {
      e = c->getArg(0);
    } else {
      break;
    }
  }
  if (const auto* self = dyn_cast<CXXThisExpr>(e)) return self->getType()->getPointeeType().isConstQualified();
  const auto* r = dyn_cast<DeclRefExpr>(e);
  return r != nullptr && r->getDecl()->getType().getNonReferenceType().isConstQualified();
}

std::string translator::variable(const VarDecl* v) {
  const bool refers = v->getType()->isReferenceType();
  if (refers && !names_constant(v)) {
    return reject(v->getLocation(), "local reference: make a copy, or name the place each time");
  }
  if ((v->isStaticLocal() && !v->isConstexpr()) || v->getTSCSpec() != TSCS_unspecified) {
    return reject(v->getLocation(), "static local variable");
  }
  if (v->getType().isVolatileQualified()) return reject(v->getLocation(), "volatile");
  const glsl_type type = type_of(v->getType(), v->getLocation());
  const std::string declared = type.declare(local_name(v));
  const Expr* init = v->getInit();
  if (const auto* made = dyn_cast_or_null<CXXConstructExpr>(init)) {
    if (made->getNumArgs() == 0 && !made->requiresZeroInitialization()) init = nullptr;
  }
  if (init == nullptr) return declared;
  const bool constant = v->getType().isConstQualified() || refers;
  return (constant ? "const " : "") + declared + " = " + expression(init, position::whole);
}

void translator::check_name(const std::string& name, bool is_field, SourceLocation where) {
  const std::string problem = bad_name(name, is_field);
  if (!problem.empty()) reject(where, problem);
}

/// The name of a local or a parameter, kept. In functions that reach the shader's cells every one gets a prefix that
/// no shader's name has, for there the shader's own text is expanded among them.
std::string translator::local_name(const ValueDecl* v) {
  const std::string name = v->getNameAsString();
  check_name(name, false, v->getLocation());
  if (name.rfind("pelage_", 0) == 0 || name.rfind("PELAGE_", 0) == 0) {
    reject(v->getLocation(), "the name `" + name + "` begins like the mirror's global names");
  }
  const std::string result = in_storage_ ? "pelage_" + name : name;
  locals_.insert(result);
  renamed_[v] = result;
  return result;
}

}  // namespace pelage::codegen
