// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "names.hpp"
#include "translator.hpp"

namespace pelage::codegen {

using namespace clang;

namespace {

/// The declaration that all instantiations share: the first one of the template's pattern.
const NamedDecl* pattern_of(const NamedDecl* d) {
  const NamedDecl* pattern = nullptr;
  if (const auto* f = dyn_cast<FunctionDecl>(d)) pattern = f->getTemplateInstantiationPattern();
  if (const auto* r = dyn_cast<CXXRecordDecl>(d)) pattern = r->getTemplateInstantiationPattern();
  if (const auto* v = dyn_cast<VarDecl>(d)) pattern = v->getTemplateInstantiationPattern();
  if (const auto* e = dyn_cast<EnumDecl>(d)) pattern = e->getTemplateInstantiationPattern();
  return cast<NamedDecl>((pattern == nullptr ? d : pattern)->getCanonicalDecl());
}

/// Where a declaration begins, `template <...>` included.
SourceLocation begin_of(const NamedDecl* d) {
  const TemplateDecl* t = nullptr;
  if (const auto* f = dyn_cast<FunctionDecl>(d)) t = f->getDescribedFunctionTemplate();
  if (const auto* r = dyn_cast<CXXRecordDecl>(d)) t = r->getDescribedClassTemplate();
  if (const auto* v = dyn_cast<VarDecl>(d)) t = v->getDescribedVarTemplate();
  return t == nullptr ? d->getBeginLoc() : t->getBeginLoc();
}

}  // namespace

entity& translator::slot(const NamedDecl* d) {
  std::unique_ptr<entity>& place = entities_[pattern_of(d)];
  if (!place) place = std::make_unique<entity>();
  return *place;
}

void translator::require(const NamedDecl* d) {
  if (required_.insert(d->getCanonicalDecl()).second) waiting_.push_back(d);
}

std::string translator::use(const NamedDecl* d, SourceLocation where) {
  require(d);
  if (fresh_) fresh_->needs.emplace_back(&slot(d), where);
  return global_name(d);
}

void translator::finish() {
  for (; !waiting_.empty(); waiting_.pop_front()) {
    const NamedDecl* next = waiting_.front();
    if (const auto* f = dyn_cast<FunctionDecl>(next)) {
      translate_function(f);
    } else if (const auto* r = dyn_cast<CXXRecordDecl>(next)) {
      translate_record(r);
    } else if (const auto* e = dyn_cast<EnumDecl>(next)) {
      translate_enum(e);
    } else {
      translate_constant(cast<VarDecl>(next));
    }
  }
  check_recursion();
  check_overloads();
  check_sizes();
  mark_sized();
}

/// Starts a definition. False where there is nothing to write: the place is not ours, or is mirrored already.
bool translator::begin(const NamedDecl* d) {
  const NamedDecl* pattern = pattern_of(d);
  const SourceLocation where = begin_of(pattern);
  fresh_ = std::make_unique<entity>();
  fresh_->name = global_name(d);
  fresh_->location = d->getLocation();
  locals_.clear();
  renamed_.clear();
  in_storage_ = arithmetic_ = false;
  fresh_->where = unit_of_(file(where));
  if (fresh_->where == nullptr) {
    reject(where, d->getQualifiedNameAsString() + " lies in a header that is not mirrored");
    return false;
  }
  set_templates(d);
  if (fresh_->where->mirrored) {
    if (fresh_->where->mirror_text.find(fresh_->name) == std::string::npos) {
      reject(where, d->getQualifiedNameAsString() + " is not in the mirror " + fresh_->where->include);
    }
    slot(d).name = fresh_->name;
    slot(d).where = fresh_->where;
    return false;
  }
  if (d->getDeclContext()->isTranslationUnit() || fresh_->name.find("__") != std::string::npos) {
    check_name(fresh_->name, false, d->getLocation());
  }
  fresh_->doc = doc_above(where);
  fresh_->declared_at = {offset(where), 1u};
  fresh_->defined_at = offset(where);
  if (d->getDeclContext()->isRecord() && (isa<VarDecl>(d) || isa<EnumDecl>(d))) {
    // A record's own constants stand before it: its fields may need them.
    const auto* owner = cast<NamedDecl>(Decl::castFromDeclContext(d->getDeclContext()));
    fresh_->declared_at = {offset(begin_of(pattern_of(owner))), 0u};
  }
  return true;
}

/// Files the definition in hand, or compares it with the one that another instantiation gave.
void translator::end(const NamedDecl* d) {
  for (const auto& [needed, where] : fresh_->needs) {
    if (locals_.count(needed->name) != 0) {
      reject(where, "the local name `" + needed->name + "` hides the function or constant of that name in GLSL");
    }
  }
  entity& place = slot(d);
  if (place.name.empty()) {
    place = std::move(*fresh_);
    place.where->entities.push_back(&place);
  } else {
    check_alike(place, *fresh_, d->getLocation());
  }
  fresh_.reset();
}

void translator::check_alike(const entity& one, const entity& other, SourceLocation where) {
  const std::string a = one.declaration + one.body;
  const std::string b = other.declaration + other.body;
  if (a == b && one.bindings == other.bindings) return;
  std::size_t i = 0;
  while (i < a.size() && i < b.size() && a[i] == b[i])
    ++i;
  const auto line_at = [i](const std::string& text) {
    const std::size_t start = i == 0 ? 0 : text.rfind('\n', i - 1);
    const std::size_t first = start == std::string::npos ? 0 : start + (i == 0 ? 0 : 1);
    const std::string whole = text.substr(first, text.find('\n', i) - first);
    return whole.substr(0, whole.find("  //"));
  };
  reject(where, "two instantiations of " + one.name + " differ, so a size or a type is lost: `" + line_at(a) +
                    "` and `" + line_at(b) + "`");
}

void translator::translate_function(const FunctionDecl* f) {
  const FunctionDecl* definition = f->getDefinition();
  if (definition == nullptr) {
    reject(f->getLocation(), f->getQualifiedNameAsString() + " has no definition here");
    return;
  }
  if (!begin(f)) return;
  const auto* method = dyn_cast<CXXMethodDecl>(f);
  in_storage_ = method != nullptr && is_storage(method->getParent());
  const FunctionDecl* pattern = f->getTemplateInstantiationPattern();
  const FunctionDecl* written = (pattern == nullptr ? f : pattern)->getDefinition();
  fresh_->defined_at = offset(begin_of(written == nullptr ? definition : written));

  const SourceLocation where = f->getLocation();
  if (f->getReturnType()->isReferenceType()) reject(where, "reference as a result: return a value");
  if (f->isVariadic()) reject(where, "variadic function");
  if (method != nullptr && method->isVirtual()) reject(where, "virtual function");
  if (f->isOverloadedOperator() && operator_name(f).empty())
    reject(where, "operator overload: call a function instead");
  const std::string result = type_of(f->getReturnType(), where).text();
  std::string list = parameters(definition);
  fresh_->body = glsl(definition->getBody(), position::statement);
  // No fused multiply-add may come between the two: `precise` covers all that leads to a result.
  const std::string precise = arithmetic_ && !f->getReturnType()->isVoidType() ? "precise " : "";
  for (std::size_t i = list.find("inout "); arithmetic_ && i != std::string::npos; i = list.find("inout ", i + 14)) {
    list.insert(i, "precise ");
  }
  fresh_->declaration = precise + result + " " + fresh_->name + "(" + list + ")";
  if (in_storage_) fresh_->doc = doc_above(f->getBeginLoc());
  end(f);
}

std::string translator::parameters(const FunctionDecl* f) {
  std::string list;
  const auto* method = dyn_cast<CXXMethodDecl>(f);
  fresh_->signature = fresh_->name + "(";
  if (method != nullptr && !method->isStatic() && !in_storage_) {
    const std::string type = type_of(context_.getRecordType(method->getParent()), f->getLocation()).text();
    list = (method->isConst() ? "" : "inout ") + type + " self";
    fresh_->signature += type + ",";
    locals_.insert("self");
  }
  for (const ParmVarDecl* p : f->parameters()) {
    if (is_storage_type(p->getType())) {
      if (!p->getType()->isReferenceType()) reject(p->getLocation(), "storage by value: pass it by reference");
      continue;
    }
    if (p->getType()->isRValueReferenceType()) reject(p->getLocation(), "rvalue reference");
    const glsl_type type = type_of(p->getType(), p->getLocation());
    const std::string name = p->getNameAsString().empty() ? std::string() : local_name(p);
    const std::string declared = name.empty() ? type.text() : type.declare(name);
    list += (list.empty() ? "" : ", ") + std::string(writes_to(p->getType()) ? "inout " : "") + declared;
    fresh_->signature += type.text() + ",";
  }
  return list;
}

void translator::translate_record(const CXXRecordDecl* r) {
  if (is_storage(r) || !begin(r)) return;
  const SourceLocation where = r->getLocation();
  if (r->isUnion()) reject(where, "union");
  if (r->getNumBases() != 0) reject(where, "base class");
  if (r->isPolymorphic()) reject(where, "virtual function");
  if (r->hasUserDeclaredConstructor() || r->hasUserDeclaredDestructor()) {
    reject(where, "struct with a constructor or a destructor: only aggregates are in the subset");
  }
  if (r->field_empty()) reject(where, "struct without members");
  std::string text = "struct " + fresh_->name + " {\n";
  for (const FieldDecl* f : r->fields()) {
    if (f->isBitField()) reject(f->getLocation(), "bit-field");
    if (f->getAccess() != AS_public) reject(f->getLocation(), "member that is not public");
    if (f->getType()->isReferenceType()) reject(f->getLocation(), "reference as a member");
    if (f->hasInClassInitializer()) reject(f->getLocation(), "member with a default value");
    check_name(f->getNameAsString(), true, f->getLocation());
    const std::string doc = doc_beside(f->getLocation());
    text += doc_above(f->getBeginLoc());
    text += type_of(f->getType(), f->getLocation()).declare(f->getNameAsString()) + ";  " + doc + "\n";
  }
  fresh_->declaration = text + "};";
  for (const Decl* d : r->decls()) {
    if (const auto* check = dyn_cast<StaticAssertDecl>(d)) note_condition(check);
  }
  end(r);
}

/// GLSL has no enumerations: constants of their names.
void translator::translate_enum(const EnumDecl* e) {
  if (!begin(e)) return;
  const std::string type = scalar_type(e->getIntegerType(), e->getLocation());
  for (const EnumConstantDecl* c : e->enumerators()) {
    const std::string value = llvm::toString(c->getInitVal(), 10) + (type == "uint" ? "u" : "");
    const std::string doc = doc_beside(c->getLocation());
    fresh_->declaration +=
        "const " + type + " " + fresh_->name + "_" + c->getNameAsString() + " = " + value + ";  " + doc + "\n";
  }
  end(e);
}

void translator::translate_constant(const VarDecl* v) {
  if (!begin(v)) return;
  const VarDecl* definition = v->getDefinition(context_);
  const Expr* init = (definition == nullptr ? v : definition)->getAnyInitializer();
  if (init == nullptr) {
    reject(v->getLocation(), "constant without a value");
    return;
  }
  const std::string declared = type_of(v->getType(), v->getLocation()).declare(fresh_->name);
  fresh_->declaration = "const " + declared + " = " + glsl(init) + ";  " + doc_beside(v->getLocation());
  end(v);
}

}  // namespace pelage::codegen
