// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include "model.hpp"

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/AST/ExprCXX.h>
#include <clang/AST/StmtCXX.h>
#include <llvm/ADT/MapVector.h>
#include <llvm/ADT/SetVector.h>
#include <llvm/ADT/StringExtras.h>
#include <llvm/ADT/StringSwitch.h>

#include <optional>

namespace pelage::codegen {

/// Where something stands: inside an expression; as a statement's value, condition or result; as a statement. Only the
/// last may assign, and only the last two may call what has an effect: inside an expression the order of evaluation,
/// which C++ and GLSL leave open each in its own way, would show.
enum class position { part, whole, statement };
inline constexpr const char* effect_inside = "call with an effect inside an expression: give its result a name first";
inline constexpr const char* assignment_inside = "assignment inside an expression: make it a statement of its own";

inline constexpr const char* narrow = "8- or 16-bit integer: use int or std::uint32_t";

/// True where a template's integer parameter stands in a statement, which a shader may set otherwise.
[[nodiscard]] bool has_size(const clang::Stmt* s);

/// The value of an explicit conversion or copy that vanishes, in parentheses where it needs them.
[[nodiscard]] std::string kept(const clang::Expr* e, const std::string& value);

/// True for a parameter or a loop's variable through which something else is written to.
[[nodiscard]] inline bool writes_to(clang::QualType variable) {
  return variable->isLValueReferenceType() && !variable.getNonReferenceType().isConstQualified();
}

/// Translates definitions into the entities of units. Every instantiation that is reached is translated; two of one
/// template must come out alike, which proves that no size or type was lost on the way.
class translator {
 public:
  translator(clang::ASTContext& context, headers& all, problems& found)
      : context_(context), sources_(context.getSourceManager()), headers_(all), found_(found) {}

  /// Asks for a function, a record, an enumeration or a constant.
  void require(const clang::NamedDecl* d);

  /// Translates what was required and what that needs in turn, then checks the whole: recursion, overloads that
  /// became one, sizes seen only once.
  void finish();

  /// What was translated, and the names within.
  [[nodiscard]] std::map<std::string, std::string> names() const;

  /// A struct of nothing but spans and pointers says where data lies: it vanishes from signatures.
  [[nodiscard]] static bool is_storage(const clang::CXXRecordDecl* r);
  [[nodiscard]] static bool is_storage(clang::QualType t) {
    return is_storage(t.getNonReferenceType()->getAsCXXRecordDecl());
  }

 private:
  struct array {
    clang::QualType element;
    std::string extent;
    std::uint64_t count;
    bool sized;  ///< by a macro
  };

  // declarations.cpp
  void translate_function(const clang::FunctionDecl* f);
  void translate_record(const clang::CXXRecordDecl* r);
  void translate_enum(const clang::EnumDecl* e);
  void translate_constant(const clang::VarDecl* v);
  bool begin(const clang::NamedDecl* d);
  void end(const clang::NamedDecl* d);
  std::string use(const clang::NamedDecl* d, clang::SourceLocation where);
  entity& slot(const clang::NamedDecl* d);
  std::vector<std::string> parameters(const clang::FunctionDecl* f);
  void reject_any(clang::SourceLocation where, const std::vector<std::pair<bool, const char*>>& reasons);
  void check_alike(const entity& one, const entity& other, clang::SourceLocation where);

  // checks.cpp
  void check_recursion();
  void check_overloads();
  void check_sizes();
  void mark_sized();

  // types.cpp
  std::string type_of(clang::QualType t, clang::SourceLocation where);
  std::string declared(const clang::ValueDecl* d, const std::string& name);
  std::string element_type(clang::QualType t, clang::SourceLocation where);
  std::string size_expression(const clang::Expr* e);
  std::string scalar_type(clang::QualType t, clang::SourceLocation where);
  std::optional<array> array_of(clang::QualType t);

  // values.cpp
  std::string spelling(clang::SourceLocation literal) const;
  std::string literal(const clang::FloatingLiteral* l);
  std::string literal(const clang::IntegerLiteral* l, clang::QualType as);
  std::string suffix(clang::QualType integer) const;
  std::string constant(const clang::Expr* e);
  std::optional<double> folded(const clang::Expr* e);
  std::string rounded(const clang::BinaryOperator* x);
  std::string listed(const std::vector<const clang::Expr*>& values);
  std::string initializer_list(const clang::InitListExpr* l);
  std::string construct(const clang::CXXConstructExpr* c);
  std::string array_value(clang::QualType type, const std::vector<const clang::Expr*>& given,
                          clang::SourceLocation where);
  std::string zero(clang::QualType t, clang::SourceLocation where);

  // sizes.cpp
  std::string size_name(const clang::NonTypeTemplateParmDecl* p, clang::SourceLocation where);
  void set_templates(const clang::Decl* d);
  void bind_sizes(const clang::Decl* used, llvm::ArrayRef<clang::TemplateArgument> written);
  void note_condition(const clang::StaticAssertDecl* check);

  // syntax.cpp
  std::string glsl(const clang::Stmt* s, position at = position::part);
  std::string outside(const clang::Stmt* s);
  std::string reject(const clang::Stmt* s, const std::string& reason);
  std::string reject(clang::SourceLocation where, const std::string& reason);

  // expressions.cpp
  std::string unary(const clang::UnaryOperator* x, position at);
  std::string binary(const clang::BinaryOperator* x, position at);
  std::string conversion(const clang::CastExpr* c, position at);
  std::string reference(const clang::DeclRefExpr* r);
  std::string member(const clang::MemberExpr* m);

  // calls.cpp
  std::string call(const clang::CallExpr* c, position at);
  std::string call(const clang::CallExpr* c, const clang::FunctionDecl* f, position at);
  std::string operator_call(const clang::CXXOperatorCallExpr* c, position at);
  std::string library_call(const clang::CallExpr* c, const clang::FunctionDecl* f);

  // storage.cpp
  std::string cell_macro(const clang::Expr* e, const std::string& suffix, const std::string& parameter);
  const clang::Expr* counted_span(const clang::CastExpr* c) const;
  std::string atomic(const clang::CallExpr* c, const clang::Expr* reference, const std::string& name, unsigned first,
                     position at);
  std::string subgroup_body(const clang::FunctionDecl* f);

  // statements.cpp
  std::string statement(const clang::Stmt* s);
  std::string between(clang::FileID where, unsigned from, unsigned to);
  std::string as_written(const clang::Stmt* s);
  std::string control(const clang::Stmt* s, const std::string& keyword, bool declares);
  std::string compound(const clang::CompoundStmt* s);
  std::string if_statement(const clang::IfStmt* s);
  std::string switch_statement(const clang::SwitchStmt* s);
  std::string range_loop(const clang::CXXForRangeStmt* s);
  std::string variables(const clang::DeclStmt* s);
  std::string variable(const clang::VarDecl* v);
  static bool names_constant(const clang::VarDecl* v);
  void check_name(const std::string& name, bool is_field, clang::SourceLocation where);
  std::string local_name(const clang::ValueDecl* v);
  unsigned end_of(const clang::Stmt* s, bool below) const;

  unsigned offset(clang::SourceLocation l) const { return sources_.getFileOffset(sources_.getExpansionLoc(l)); }
  clang::FileID file(clang::SourceLocation l) const { return sources_.getFileID(sources_.getExpansionLoc(l)); }

  clang::ASTContext& context_;
  clang::SourceManager& sources_;
  headers& headers_;
  problems& found_;

  llvm::MapVector<const clang::Decl*, std::unique_ptr<entity>> entities_;  ///< by the pattern's canonical declaration
  llvm::SetVector<const clang::NamedDecl*> required_;                      ///< instantiations
  std::map<std::string, std::map<std::string, clang::SourceLocation>> sizes_seen_;  ///< by template, where

  // Of the definition in hand.
  std::unique_ptr<entity> fresh_;
  std::vector<const clang::TemplateDecl*> templates_;  ///< enclosing ones, outermost first
  std::vector<std::pair<std::string, llvm::APSInt>> size_values_;
  bool in_storage_ = false;
  bool arithmetic_ = false;  ///< floating-point arithmetic seen
  std::set<std::string> locals_;
  std::map<const clang::ValueDecl*, std::string> renamed_;
};

}  // namespace pelage::codegen
