// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "names.hpp"
#include "translator.hpp"

#include <clang/Lex/Lexer.h>
#include <llvm/ADT/TypeSwitch.h>

namespace pelage::codegen {

using namespace clang;

namespace {

/// True for a statement that stands below another one: in a block, behind a case, as a branch or a loop's body.
bool is_below(const Stmt* part, const Stmt* of) {
  return llvm::TypeSwitch<const Stmt*, bool>(of)
      .Case<ForStmt, WhileStmt, DoStmt>([&](const auto* x) { return part == x->getBody(); })
      .Case<IfStmt>([&](const auto* x) { return part == x->getThen() || part == x->getElse(); })
      .Case<SwitchCase>([&](const auto* x) { return part == x->getSubStmt(); })
      .Default([](const Stmt* x) { return isa<CompoundStmt>(x); });
}

bool ends_line(llvm::StringRef source, unsigned from) {
  return source.substr(from).ltrim(" \t\r").startswith("\n");
}

/// a of a.b[i].c.
const Expr* root_of(const Expr* e) {
  e = e->IgnoreParenImpCasts();
  if (const auto* m = dyn_cast<MemberExpr>(e)) return root_of(m->getBase());
  const auto* c = dyn_cast<CXXOperatorCallExpr>(e);
  return c != nullptr && c->getOperator() == OO_Subscript ? root_of(c->getArg(0)) : e;
}

/// The keywords that the header's own text between translated parts may hold.
const std::set<llvm::StringRef> kept_keywords = {"if",   "else",    "for",    "while", "do",      "switch",
                                                 "case", "default", "return", "break", "continue"};

constexpr const char* macro_of_statements = "macro of statements: write a function";

std::string braced(const std::string& text) {
  return text.rfind('{', 0) == 0 ? text : "{\n" + text + "\n}";
}

}  // namespace

/// A statement with its semicolon.
std::string translator::statement(const Stmt* s) {
  const auto* e = dyn_cast<Expr>(s);
  if (e != nullptr && !e->HasSideEffects(context_) && !e->getType()->isVoidType()) {
    return reject(s, "statement without effect");
  }
  const std::string one = glsl(s, position::statement);
  const bool open = isa<Expr, ReturnStmt, BreakStmt, ContinueStmt, DoStmt>(s) && !one.empty() && one.back() != '}';
  return open ? one + ";" : one;
}

/// The header's text between two parts, once it is known to mean the same in GLSL: keywords, brackets, comments.
std::string translator::between(FileID where, unsigned from, unsigned to) {
  std::string text = sources_.getBufferData(where).slice(from, to).str();
  const SourceLocation first = sources_.getLocForStartOfFile(where).getLocWithOffset(static_cast<int>(from));
  Lexer lexer(first, context_.getLangOpts(), text.data(), text.data(), text.data() + text.size());
  Token one;
  for (lexer.LexFromRawLexer(one); one.isNot(tok::eof); lexer.LexFromRawLexer(one)) {
    const std::string spelled = text.substr(offset(one.getLocation()) - from, one.getLength());
    if (one.is(tok::hash)) return reject(one.getLocation(), "preprocessor line inside a function");
    const bool name = one.is(tok::raw_identifier);
    if (name ? kept_keywords.count(spelled) != 0 : spelled.find_first_not_of("{}();:") == std::string::npos) continue;
    return reject(one.getLocation(), name ? macro_of_statements : "`" + spelled + "` between statements");
  }
  return text;
}

/// The header's text of a statement, comments and blank lines included, with its parts in GLSL.
std::string translator::as_written(const Stmt* s) {
  const SourceLocation begin = s->getBeginLoc();
  const FileID where = file(begin);
  if (begin.isMacroID()) return reject(begin, macro_of_statements);
  const auto* loop = dyn_cast<ForStmt>(s);
  std::string result;
  unsigned done = offset(begin);
  for (const Stmt* part : s->children()) {
    if (part == nullptr || isa<NullStmt>(part)) continue;
    if (offset(part->getBeginLoc()) < done) return reject(begin, macro_of_statements);
    const bool below = is_below(part, s);
    const bool acts = loop != nullptr && part != loop->getCond();
    std::string one = below ? statement(part) : glsl(part, acts ? position::statement : position::whole);
    if (below && !isa<CompoundStmt, SwitchCase>(s) && one.rfind("if (", 0) != 0) one = braced(one);
    result += between(where, done, offset(part->getBeginLoc()));
    done = end_of(part, below);
    // What is left of the line must not move up into a comment.
    if (one.empty() && ends_line(sources_.getBufferData(where), done)) result.erase(result.find_last_not_of(" \n") + 1);
    result += one;
  }
  return result + between(where, done, end_of(s, false));
}

/// Where a statement's text ends; `below`: behind its semicolon.
unsigned translator::end_of(const Stmt* s, bool below) const {
  const LangOptions& language = context_.getLangOpts();
  const SourceLocation last = sources_.getExpansionRange(s->getEndLoc()).getEnd();
  const SourceLocation behind = Lexer::findLocationAfterToken(last, tok::semi, sources_, language, false);
  return offset(below && behind.isValid() ? behind : Lexer::getLocForEndOfToken(last, 0, sources_, language));
}

std::string translator::control(const Stmt* s, const std::string& keyword, bool declares) {
  return declares ? reject(s, "declaration inside `" + keyword + "`") : as_written(s);
}

std::string translator::compound(const CompoundStmt* s) {
  const auto* only = s->size() == 1 ? dyn_cast<IfStmt>(s->body_front()) : nullptr;
  // The branch that is taken stands in the place of the block round it.
  return only != nullptr && only->isConstexpr() ? braced(if_statement(only)) : as_written(s);
}

std::string translator::if_statement(const IfStmt* s) {
  const bool declares = s->hasInitStorage() || s->hasVarStorage();
  if (declares || !s->isConstexpr()) return control(s, "if", declares);
  if (has_size(s->getCond())) return reject(s, "`if constexpr` over a size: the size is lost, use a plain `if`");
  bool taken = false;
  (void)s->getCond()->EvaluateAsBooleanCondition(taken, context_);
  const Stmt* branch = taken ? s->getThen() : s->getElse();
  return branch == nullptr ? std::string() : statement(branch);
}

/// GLSL has labels in the switch's own block alone, and nothing before the first.
std::string translator::switch_statement(const SwitchStmt* s) {
  const auto* block = dyn_cast<CompoundStmt>(s->getBody());
  if (block == nullptr) return reject(s, "switch without a block");
  std::set<const SwitchCase*> own;
  for (const Stmt* one : block->body()) {
    for (auto label = dyn_cast<SwitchCase>(one); label != nullptr; label = dyn_cast<SwitchCase>(label->getSubStmt()))
      own.insert(label);
    if (own.empty()) return reject(one, "statement before the first case");
  }
  for (const SwitchCase* label = s->getSwitchCaseList(); label != nullptr; label = label->getNextSwitchCase())
    if (own.count(label) == 0) reject(label, "case inside another statement");
  return control(s, "switch", s->hasInitStorage() || s->hasVarStorage());
}

/// for (T x : array): a loop over a counter that no other name can meet.
std::string translator::range_loop(const CXXForRangeStmt* s) {
  if (s->getInit() != nullptr) return reject(s->getInit(), "statement in the head of a range-for");
  const VarDecl* v = s->getLoopVariable();
  const Expr* range = s->getRangeInit()->IgnoreParenImpCasts();
  QualType range_type = range->getType();
  if (const auto* m = dyn_cast<MemberExpr>(range)) range_type = m->getMemberDecl()->getType();
  if (const auto* r = dyn_cast<DeclRefExpr>(range)) range_type = r->getDecl()->getType();
  const std::optional<array> items = array_of(range_type.getNonReferenceType().getUnqualifiedType());
  if (!items) return reject(range, "range-for over something other than a std::array");
  const std::string name = local_name(v);
  const std::string index = "pelage_" + name + "_index";
  const std::string item = glsl(range) + "[" + index + "]";
  std::string first;
  if (writes_to(v->getType())) {
    renamed_[v] = item;
  } else {
    const bool constant = v->getType().isConstQualified();
    first = (constant ? "\nconst " : "\n") + declared(v, name) + " = " + item + ";";
  }
  return "for (int " + index + " = 0; " + index + " < " + items->extent + "; ++" + index + ") {" + first +
         braced(statement(s->getBody())).substr(1);
}

std::string translator::variables(const DeclStmt* s) {
  std::string text;
  for (const Decl* d : s->decls()) {
    if (const auto* check = dyn_cast<StaticAssertDecl>(d)) note_condition(check);
    if (isa<StaticAssertDecl, TypedefNameDecl, UsingDecl, UsingDirectiveDecl>(d)) continue;
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
  const Expr* root = root_of(v->getInit());
  if (isa<CXXThisExpr>(root)) return root->getType()->getPointeeType().isConstQualified();
  const auto* r = dyn_cast<DeclRefExpr>(root);
  return r != nullptr && r->getDecl()->getType().getNonReferenceType().isConstQualified();
}

std::string translator::variable(const VarDecl* v) {
  const bool refers = v->getType()->isReferenceType();
  if (refers && !names_constant(v)) {
    return reject(v->getLocation(), "local reference: make a copy, or name the place each time");
  }
  const bool lasting = (v->isStaticLocal() && !v->isConstexpr()) || v->getTSCSpec() != TSCS_unspecified;
  reject_any(v->getLocation(), {{lasting, "static local variable"}, {v->getType().isVolatileQualified(), "volatile"}});
  const std::string bare = declared(v, local_name(v));
  const Expr* init = v->getInit();
  const auto* made = dyn_cast_or_null<CXXConstructExpr>(init);
  const bool empty = made != nullptr && made->getNumArgs() == 0 && !made->requiresZeroInitialization();
  if (init == nullptr || empty) return bare;
  const bool constant = v->getType().isConstQualified() || refers;
  return (constant ? "const " : "") + bare + " = " + glsl(init, position::whole);
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
