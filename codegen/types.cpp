// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "names.hpp"
#include "translator.hpp"

namespace pelage::codegen {

using namespace clang;

bool translator::is_storage(const CXXRecordDecl* r) {
  return r != nullptr && r->hasDefinition() && !r->isInStdNamespace() && !r->field_empty() &&
         llvm::all_of(r->fields(), [](const FieldDecl* f) {
           return f->getType()->isPointerType() || is_std_type(f->getType(), "span");
         });
}

bool is_wide(const DeclContext* record) {
  const auto* r = dyn_cast<ClassTemplateSpecializationDecl>(record);
  if (r == nullptr || !translator::is_storage(r) || r->getTemplateArgs()[0].getKind() != TemplateArgument::Type) {
    return false;
  }
  const QualType word = r->getTemplateArgs()[0].getAsType();
  return word->isIntegerType() && r->getASTContext().getTypeSize(word) == 64;
}

/// std::array, with the size as it is written: the canonical type knows only one instantiation's number.
std::optional<translator::array> translator::array_of(QualType t) {
  const auto* written = t->getAs<TemplateSpecializationType>();
  while (written != nullptr && written->isTypeAlias())
    written = written->getAliasedType()->getAs<TemplateSpecializationType>();
  if (!is_std_type(t, "array")) return std::nullopt;
  const auto* known = cast<ClassTemplateSpecializationDecl>(t.getNonReferenceType()->getAsCXXRecordDecl());
  const llvm::APSInt count = known->getTemplateArgs()[1].getAsIntegral();
  array result = {known->getTemplateArgs()[0].getAsType(), llvm::toString(count, 10), count.getZExtValue(), false};
  if (written == nullptr) return result;
  result.element = written->getArg(0).getAsType();
  if (written->getArg(1).getKind() == TemplateArgument::Expression) {
    result.extent = size_expression(written->getArg(1).getAsExpr());
    result.sized = has_size(written->getArg(1).getAsExpr());
  }
  return result;
}

/// The size of an array: a size_t to C++, a plain number here.
std::string translator::size_expression(const Expr* e) {
  e = e->IgnoreImplicit();  // not IgnoreParenImpCasts(), which sees through a template's parameter to its value
  const auto* number = dyn_cast<IntegerLiteral>(e);
  return number == nullptr ? glsl(e) : llvm::toString(number->getValue(), 10, false);
}

std::string translator::scalar_type(QualType t, SourceLocation where) {
  static const std::map<BuiltinType::Kind, std::string> same = {{BuiltinType::Void, "void"},
                                                                {BuiltinType::Bool, "bool"},
                                                                {BuiltinType::Int, "int"},
                                                                {BuiltinType::UInt, "uint"},
                                                                {BuiltinType::Float, "float"}};
  const auto* builtin = t->getAs<BuiltinType>();
  if (builtin == nullptr) return reject(where, "type " + t.getAsString() + " has no GLSL form");
  if (const auto found = same.find(builtin->getKind()); found != same.end()) return found->second;
  if (builtin->isFloatingPoint()) return reject(where, "double: the mirror computes in float");
  const std::uint64_t width = context_.getTypeSize(t);
  if (width < 32) return reject(where, narrow);
  if (width > 64 || !builtin->isInteger()) return reject(where, "type " + t.getAsString() + " has no GLSL form");
  const auto* declared = t->getAs<TypedefType>();
  std::string name = declared == nullptr ? "" : declared->getDecl()->getName().str();
  if (t->getAs<SubstTemplateTypeParmType>() != nullptr) name = t->isUnsignedIntegerType() ? "uint64_t" : "int64_t";
  if (name != "uint64_t" && name != "int64_t") {
    return reject(where, "64-bit integer that is not declared as std::uint64_t or std::int64_t" +
                             (name.empty() ? "" : " but as " + name));
  }
  fresh_->where->uses_int64 = true;
  return name;
}

/// A type as its constructor is called: float[4][3].
std::string translator::type_of(QualType t, SourceLocation where) {
  t = t.getNonReferenceType().getUnqualifiedType();
  std::string extents;
  for (auto a = array_of(t); a; a = array_of(t)) {
    extents += "[" + a->extent + "]";
    t = a->element;
  }
  return element_type(t, where) + extents;
}

/// What declares a name: float x[4][3].
std::string translator::declared(const ValueDecl* d, const std::string& name) {
  const std::string type = type_of(d->getType(), d->getLocation());
  const std::size_t end = std::min(type.find('['), type.size());
  return type.substr(0, end) + " " + name + type.substr(end);
}

/// The name of a type that is no std::array.
std::string translator::element_type(QualType t, SourceLocation where) {
  if (t->isPointerType()) return reject(where, "pointer");
  if (t->isArrayType()) return reject(where, "C array: use std::array");
  if (const auto* e = t->getAs<EnumType>()) {
    if (e->getDecl()->isInStdNamespace()) return "int";  // std::memory_order
    use(e->getDecl(), where);
    return scalar_type(e->getDecl()->getIntegerType(), where);
  }
  const auto* record = t->getAsCXXRecordDecl();
  if (record == nullptr) return scalar_type(t, where);
  const std::string name = record->getQualifiedNameAsString();
  if (name == "glm::vec" || name == "glm::mat") {
    const auto arguments = cast<ClassTemplateSpecializationDecl>(record)->getTemplateArgs().asArray();
    const std::string columns = llvm::toString(arguments[0].getAsIntegral(), 10);
    const std::string scalar = scalar_type(arguments[name == "glm::vec" ? 1 : 2].getAsType(), where);
    if (name == "glm::vec") return (scalar == "float" ? "" : scalar.substr(0, 1)) + "vec" + columns;
    const std::string rows = llvm::toString(arguments[1].getAsIntegral(), 10);
    return "mat" + columns + (columns == rows ? "" : "x" + rows);
  }
  if (is_storage(record)) return reject(where, "storage can only be a function's parameter");
  if (is_in(record, "std") || is_in(record, "glm")) return reject(where, name + " is not in the subset");
  if (record->isLambda()) return reject(where, "lambda");
  const auto* written = t->getAs<TemplateSpecializationType>();
  bind_sizes(record, written == nullptr ? llvm::ArrayRef<TemplateArgument>() : written->template_arguments());
  return use(record, where);
}

}  // namespace pelage::codegen
