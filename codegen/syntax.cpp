// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The list of the language: what passes as it is written, where what does not is translated, and what is outside.
#include "translator.hpp"

#include <llvm/ADT/TypeSwitch.h>

namespace pelage::codegen {

using namespace clang;

namespace {

const std::map<Stmt::StmtClass, const char*> no_form = {
    {Stmt::ArraySubscriptExprClass, "C array: use std::array"},
    {Stmt::CXXDeleteExprClass, "allocation"},
    {Stmt::CXXNewExprClass, "allocation"},
    {Stmt::CXXNullPtrLiteralExprClass, "pointer"},
    {Stmt::CXXRewrittenBinaryOperatorClass, "comparison of structs: write it out"},
    {Stmt::CXXStdInitializerListExprClass, "std::initializer_list"},
    {Stmt::CXXThisExprClass, "pointer"},
    {Stmt::CXXThrowExprClass, "exceptions"},
    {Stmt::CXXTryStmtClass, "exceptions"},
    {Stmt::CharacterLiteralClass, "character or string"},
    {Stmt::GotoStmtClass, "goto and labels"},
    {Stmt::LabelStmtClass, "goto and labels"},
    {Stmt::LambdaExprClass, "lambda"},
    {Stmt::StmtExprClass, "statement inside an expression"},
    {Stmt::StringLiteralClass, "character or string"},
    {Stmt::UnaryExprOrTypeTraitExprClass, "sizeof and alignof"},
};

}  // namespace

std::string translator::glsl(const Stmt* s, position at) {
  return llvm::TypeSwitch<const Stmt*, std::string>(s)
      .Case<FullExpr, MaterializeTemporaryExpr, CXXBindTemporaryExpr>(
          [&](const auto* x) { return glsl(x->getSubExpr(), at); })
      .Case<CXXDefaultArgExpr>([&](const auto* x) { return glsl(x->getExpr(), at); })
      .Case<SubstNonTypeTemplateParmExpr>([&](const auto* x) { return size_name(x->getParameter(), x->getBeginLoc()); })
      .Case<IntegerLiteral>([&](const auto* x) { return literal(x, x->getType()); })
      .Case<FloatingLiteral>([&](const auto* x) {
        const bool real = context_.hasSameUnqualifiedType(x->getType(), context_.FloatTy);
        return real ? literal(x) : reject(x, "double literal: add `f`, or convert it with Real(...)");
      })
      .Case<CXXBoolLiteralExpr>([](const auto* x) { return x->getValue() ? "true" : "false"; })
      .Case<CXXScalarValueInitExpr, ImplicitValueInitExpr>(
          [&](const auto* x) { return zero(x->getType(), x->getExprLoc()); })
      .Case<InitListExpr>([&](const auto* x) { return initializer_list(x); })
      .Case<CXXConstructExpr>([&](const auto* x) { return construct(x); })
      .Case<DeclRefExpr>([&](const auto* x) { return reference(x); })
      .Case<MemberExpr>([&](const auto* x) { return member(x); })
      .Case<CastExpr>([&](const auto* x) { return conversion(x, at); })
      .Case<CXXOperatorCallExpr>([&](const auto* x) { return operator_call(x, at); })
      .Case<CallExpr>([&](const auto* x) { return call(x, at); })
      .Case<ParenExpr>([&](const auto* x) {
        const std::string inner = glsl(x->getSubExpr(), at);
        return x->getType()->isVoidType() ? inner : "(" + inner + ")";
      })
      .Case<UnaryOperator>([&](const auto* x) { return unary(x, at); })
      .Case<BinaryOperator>([&](const auto* x) { return binary(x, at); })
      .Case<ConditionalOperator>([&](const auto* x) {
        const position branch = std::min(at, position::whole);
        return glsl(x->getCond()) + " ? " + glsl(x->getTrueExpr(), branch) + " : " + glsl(x->getFalseExpr(), branch);
      })
      .Case<DeclStmt>([&](const auto* x) { return variables(x); })
      .Case<CompoundStmt>([&](const auto* x) { return compound(x); })
      .Case<IfStmt>([&](const auto* x) { return if_statement(x); })
      .Case<CXXForRangeStmt>([&](const auto* x) { return range_loop(x); })
      .Case<ForStmt>([&](const auto* x) {
        const auto* first = dyn_cast_or_null<DeclStmt>(x->getInit());
        return first != nullptr && !first->isSingleDecl() ? reject(first, "several variables in the head of `for`")
                                                          : control(x, "for", x->getConditionVariable() != nullptr);
      })
      .Case<WhileStmt>([&](const auto* x) { return control(x, "while", x->hasVarStorage()); })
      .Case<SwitchStmt>([&](const auto* x) { return switch_statement(x); })
      .Case<CaseStmt>(
          [&](const auto* x) { return x->caseStmtIsGNURange() ? reject(x, "range of cases") : as_written(x); })
      .Case<DefaultStmt, DoStmt, ReturnStmt, BreakStmt, ContinueStmt>([&](const auto* x) { return as_written(x); })
      .Case<NullStmt>([](const auto*) { return ""; })
      .Case<AttributedStmt>([&](const auto* x) { return statement(x->getSubStmt()); })
      .Default([&](const Stmt* x) { return outside(x); });
}

std::string translator::outside(const Stmt* s) {
  const auto known = no_form.find(s->getStmtClass());
  return reject(s,
                known == no_form.end() ? std::string(s->getStmtClassName()) + " is not in the subset" : known->second);
}

std::string translator::reject(const Stmt* s, const std::string& reason) {
  return reject(s->getBeginLoc(), reason);
}

std::string translator::reject(SourceLocation where, const std::string& reason) {
  found_.add(where, reason);
  return "0";
}

}  // namespace pelage::codegen
