// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "names.hpp"
#include "translator.hpp"

namespace pelage::codegen {

using namespace clang;

namespace {

bool is_std(const NamedDecl* d, llvm::StringRef name) {
  return d != nullptr && d->isInStdNamespace() && d->getName() == name;
}

/// The name of the typedef that a type was declared by, looking through templates' parameters.
std::string typedef_name(QualType t, const ASTContext& context) {
  for (;;) {
    if (const auto* named = dyn_cast<TypedefType>(t.getTypePtr())) return named->getDecl()->getName().str();
    const QualType next = t.getSingleStepDesugaredType(context);
    if (next == t) return {};
    t = next;
  }
}

}  // namespace

bool translator::is_storage(const CXXRecordDecl* r) {
  if (r == nullptr || !r->hasDefinition() || r->isInStdNamespace() || r->field_empty()) return false;
  for (const FieldDecl* f : r->fields()) {
    const CXXRecordDecl* type = f->getType()->getAsCXXRecordDecl();
    if (!f->getType()->isPointerType() && !is_std(type, "span")) return false;
  }
  return true;
}

bool translator::is_storage_type(QualType t) const {
  return is_storage(t.getNonReferenceType()->getAsCXXRecordDecl());
}

/// std::array, with the size as it is written: the canonical type knows only one instantiation's number.
bool translator::is_array(QualType t, QualType& element, std::string& extent) {
  for (;;) {
    if (const auto* written = dyn_cast<TemplateSpecializationType>(t.getTypePtr())) {
      if (!written->isTypeAlias() && is_std(written->getTemplateName().getAsTemplateDecl(), "array")) {
        const TemplateArgument& size = written->getArg(1);
        element = written->getArg(0).getAsType();
        extent = size.getKind() == TemplateArgument::Expression ? size_expression(size.getAsExpr())
                                                                : llvm::toString(size.getAsIntegral(), 10);
        return true;
      }
    }
    const QualType next = t.getSingleStepDesugaredType(context_);
    if (next == t) break;
    t = next;
  }
  const auto* array = dyn_cast_or_null<ClassTemplateSpecializationDecl>(t->getAsCXXRecordDecl());
  if (!is_std(array, "array")) return false;
  element = array->getTemplateArgs()[0].getAsType();
  extent = llvm::toString(array->getTemplateArgs()[1].getAsIntegral(), 10);
  return true;
}

/// What is converted. Not IgnoreParenImpCasts(), which would see through a template's parameter to its value.
const Expr* translator::without_conversions(const Expr* e) {
  for (;;) {
    if (const auto* outer = dyn_cast<FullExpr>(e)) {
      e = outer->getSubExpr();
    } else if (const auto* converted = dyn_cast<ImplicitCastExpr>(e)) {
      e = converted->getSubExpr();
    } else {
      return e;
    }
  }
}

/// The size of an array: a size_t to C++, a plain number here.
std::string translator::size_expression(const Expr* e) {
  e = without_conversions(e);
  if (const auto* l = dyn_cast<IntegerLiteral>(e)) return llvm::toString(l->getValue(), 10, false);
  return glsl(e);
}

std::string translator::scalar_type(QualType t, SourceLocation where) {
  const auto* builtin = t->getAs<BuiltinType>();
  switch (builtin->getKind()) {
    case BuiltinType::Void:
      return "void";
    case BuiltinType::Bool:
      return "bool";
    case BuiltinType::Int:
      return "int";
    case BuiltinType::UInt:
      return "uint";
    case BuiltinType::Float:
      return "float";
    case BuiltinType::Long:
    case BuiltinType::LongLong:
    case BuiltinType::ULong:
    case BuiltinType::ULongLong: {
      const std::string name = typedef_name(t, context_);
      if (name != "uint64_t" && name != "int64_t") {
        return reject(where, "64-bit integer that is not declared as std::uint64_t or std::int64_t" +
                                 (name.empty() ? std::string() : " but as " + name));
      }
      if (fresh_ && fresh_->where != nullptr) fresh_->where->uses_int64 = true;
      return name;
    }
    case BuiltinType::Double:
    case BuiltinType::LongDouble:
      return reject(where, "double: the mirror computes in float");
    case BuiltinType::Char_S:
    case BuiltinType::Char_U:
    case BuiltinType::SChar:
    case BuiltinType::UChar:
    case BuiltinType::Short:
    case BuiltinType::UShort:
      return reject(where, "8- or 16-bit integer: use int or std::uint32_t");
    default:
      return reject(where, "type " + t.getAsString() + " has no GLSL form");
  }
}

glsl_type translator::type_of(QualType t, SourceLocation where) {
  t = t.getNonReferenceType().getUnqualifiedType();
  std::string extents;
  std::string extent;
  for (QualType element; is_array(t, element, extent); t = element)
    extents += "[" + extent + "]";
  return {element_type(t, where), extents};
}

/// The name of a type that is no std::array.
std::string translator::element_type(QualType t, SourceLocation where) {
  if (t->isPointerType()) return reject(where, "pointer");
  if (t->isArrayType()) return reject(where, "C array: use std::array");
  if (const auto* e = t->getAs<EnumType>()) {
    if (is_std(e->getDecl(), "memory_order")) return "int";
    use(e->getDecl(), where);
    return scalar_type(e->getDecl()->getIntegerType(), where);
  }
  const auto* record = t->getAsCXXRecordDecl();
  if (record == nullptr) {
    return t->getAs<BuiltinType>() != nullptr ? scalar_type(t, where)
                                              : reject(where, "type " + t.getAsString() + " has no GLSL form");
  }
  const auto* special = dyn_cast<ClassTemplateSpecializationDecl>(record);
  const std::string name = record->getQualifiedNameAsString();
  if (special != nullptr && (name == "glm::vec" || name == "glm::mat")) {
    const bool vector = name == "glm::vec";
    const TemplateArgumentList& arguments = special->getTemplateArgs();
    const std::string scalar = scalar_type(arguments[vector ? 1 : 2].getAsType(), where);
    const std::string columns = llvm::toString(arguments[0].getAsIntegral(), 10);
    if (vector) return (scalar == "float" ? "" : scalar.substr(0, 1)) + "vec" + columns;
    const std::string rows = llvm::toString(arguments[1].getAsIntegral(), 10);
    return "mat" + columns + (columns == rows ? "" : "x" + rows);
  }
  if (is_storage(record)) return reject(where, "storage can only be a function's parameter");
  if (record->isInStdNamespace() || is_glm(record)) return reject(where, name + " is not in the subset");
  if (record->isLambda()) return reject(where, "lambda");
  bind_sizes(t);
  return use(record, where);
}

/// An array's constructor with every element, those not given 0. Their number must not be for a macro to say.
std::string translator::array_value(QualType array, const std::vector<const Expr*>& given, SourceLocation where) {
  array = array.getUnqualifiedType();
  QualType element;
  std::string extent;
  std::set<std::string> sizes;
  fresh_->sizes.swap(sizes);
  (void)is_array(array, element, extent);
  fresh_->sizes.swap(sizes);
  const std::string type = type_of(array, where).text();
  const auto* known = cast<ClassTemplateSpecializationDecl>(array->getAsCXXRecordDecl());
  const std::uint64_t count = known->getTemplateArgs()[1].getAsIntegral().getZExtValue();
  if (!sizes.empty() || count > given.size() + 16) {
    return reject(where, "an array of many zeros: declare it without a value and fill it in a loop");
  }
  std::string parts = listed(given);
  for (std::uint64_t i = given.size(); i < count; ++i)
    parts += (parts.empty() ? "" : ", ") + zero(element, where);
  return type + "(" + parts + ")";
}

/// T{} for what has a fixed number of parts.
std::string translator::zero(QualType t, SourceLocation where) {
  const glsl_type type = type_of(t, where);
  if (!type.extents.empty()) return array_value(t, {}, where);
  const auto* record = t->getAsCXXRecordDecl();
  if (record != nullptr && record->getQualifiedNameAsString().rfind("glm::", 0) != 0) {
    std::string parts;
    for (const FieldDecl* f : record->fields()) {
      parts += (parts.empty() ? "" : ", ") + zero(f->getType(), where);
    }
    return type.name + "(" + parts + ")";
  }
  if (type.name == "float") return "0.0";
  if (type.name == "bool") return "false";
  if (type.name == "int") return "0";
  if (type.name == "uint") return "0u";
  return type.name + "(0)";
}

}  // namespace pelage::codegen
