// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "names.hpp"
#include "translator.hpp"

#include <llvm/ADT/TypeSwitch.h>

namespace pelage::codegen {

using namespace clang;

namespace {

/// The declaration that all instantiations share: the first one of the template's pattern. Storage of 64-bit words has
/// functions of its own.
const NamedDecl* pattern_of(const NamedDecl* d) {
  const auto* pattern = llvm::TypeSwitch<const NamedDecl*, const NamedDecl*>(d)
                            .Case<FunctionDecl, CXXRecordDecl, VarDecl, EnumDecl>(
                                [](const auto* x) { return x->getTemplateInstantiationPattern(); })
                            .Default([](const NamedDecl*) { return nullptr; });
  return cast<NamedDecl>((pattern == nullptr ? d : pattern)->getCanonicalDecl());
}

/// A declaration with the `template <...>` before it.
const NamedDecl* whole(const NamedDecl* d) {
  const TemplateDecl* t = d->getDescribedTemplate();
  return t == nullptr ? d : t;
}

}  // namespace

entity& translator::slot(const NamedDecl* d) {
  std::unique_ptr<entity>& place = entities_[is_wide(d->getDeclContext()) ? d->getCanonicalDecl() : pattern_of(d)];
  if (!place) place = std::make_unique<entity>();
  return *place;
}

void translator::require(const NamedDecl* d) {
  slot(d);  // in the order of requirement
  required_.insert(cast<NamedDecl>(d->getCanonicalDecl()));
}

std::string translator::use(const NamedDecl* d, SourceLocation where) {
  require(d);
  fresh_->needs.emplace_back(&slot(d), where);
  return global_name(d);
}

void translator::finish() {
  for (std::size_t i = 0; i < required_.size(); ++i) {  // grows meanwhile
    llvm::TypeSwitch<const NamedDecl*>(required_[i])
        .Case<FunctionDecl>([&](const auto* f) { translate_function(f); })
        .Case<CXXRecordDecl>([&](const auto* r) { translate_record(r->getDefinition()); })
        .Case<EnumDecl>([&](const auto* e) { translate_enum(e->getDefinition()); })
        .Case<VarDecl>([&](const auto* v) { translate_constant(v); });
  }
  check_recursion();
  check_overloads();
  check_sizes();
  mark_sized();
}

std::map<std::string, std::string> translator::names() const {
  std::map<std::string, std::string> all;
  for (const auto& [decl, e] : entities_) {
    if (e->where == nullptr) continue;
    all.emplace(e->qualified, e->name);
    for (const auto& [name, in_glsl] : e->inner)
      all.emplace(e->qualified + "::" + name, in_glsl);
  }
  return all;
}

/// Starts a definition. False where there is nothing to write: the place is not ours, or is mirrored already.
bool translator::begin(const NamedDecl* d) {
  const NamedDecl* pattern = pattern_of(d);
  const SourceLocation where = whole(pattern)->getBeginLoc();
  fresh_ = std::make_unique<entity>();
  fresh_->name = global_name(d);
  fresh_->qualified = qualified_name(d);
  fresh_->location = d->getLocation();
  locals_.clear();
  renamed_.clear();
  in_storage_ = arithmetic_ = false;
  fresh_->where = headers_.unit_of(file(where), is_wide(d->getDeclContext()));
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
    slot(d).qualified = fresh_->qualified;
    slot(d).where = fresh_->where;
    // What a prefix renames depends on a size.
    if (fresh_->where->mirror_text.find("#undef " + fresh_->name + "\n") != std::string::npos) {
      for (const auto& [macro, value] : fresh_->where->sizes)
        slot(d).sizes.insert(macro);
    }
    return false;
  }
  if (d->getDeclContext()->isTranslationUnit() || fresh_->name.find("__") != std::string::npos) {
    check_name(fresh_->name, false, d->getLocation());
  }
  fresh_->doc = doc_of(whole(pattern), false);
  fresh_->declared_at = {offset(where), 1u};
  fresh_->defined_at = offset(where);
  if (d->getDeclContext()->isRecord() && (isa<VarDecl>(d) || isa<EnumDecl>(d))) {
    // A record's own constants stand before it: its fields may need them.
    const auto* owner = cast<NamedDecl>(Decl::castFromDeclContext(d->getDeclContext()));
    fresh_->declared_at = {offset(whole(pattern_of(owner))->getBeginLoc()), 0u};
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
  for (const auto& [variable, name] : renamed_)
    fresh_->inner.emplace(variable->getName(), name);
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
  auto [line, rest] = llvm::StringRef(a).split('\n');
  auto [other_line, other_rest] = llvm::StringRef(b).split('\n');
  while (line == other_line && rest != other_rest) {
    std::tie(line, rest) = rest.split('\n');
    std::tie(other_line, other_rest) = other_rest.split('\n');
  }
  reject(where, filled("two instantiations of {0} differ, so a size or a type is lost: `{1}` and `{2}`", one.name,
                       line.split("  //").first, other_line.split("  //").first));
}

void translator::reject_any(SourceLocation where, const std::vector<std::pair<bool, const char*>>& reasons) {
  for (const auto& [applies, reason] : reasons) {
    if (applies) reject(where, reason);
  }
}

void translator::translate_function(const FunctionDecl* f) {
  const FunctionDecl* definition = f->getDefinition();
  const SourceLocation where = f->getLocation();
  if (definition == nullptr) {
    reject(where, f->getQualifiedNameAsString() + " has no definition here");
    return;
  }
  if (!begin(f)) return;
  const auto* method = dyn_cast<CXXMethodDecl>(f);
  in_storage_ = method != nullptr && is_storage(method->getParent());
  const FunctionDecl* pattern = f->getTemplateInstantiationPattern();
  const FunctionDecl* written = pattern == nullptr ? nullptr : pattern->getDefinition();
  fresh_->defined_at = offset(whole(written == nullptr ? definition : written)->getBeginLoc());
  reject_any(where,
             {{f->getReturnType()->isReferenceType(), "reference as a result: return a value"},
              {f->isVariadic(), "variadic function"},
              {method != nullptr && method->isVirtual(), "virtual function"},
              {f->isOverloadedOperator() && operator_name(f).empty(), "operator overload: call a function instead"}});
  const std::string result = type_of(f->getReturnType(), where);
  std::vector<std::string> list = parameters(definition);
  fresh_->body = subgroup_body(definition);
  if (fresh_->body.empty()) fresh_->body = glsl(definition->getBody(), position::statement);
  // No fused multiply-add may come between the two: `precise` covers all that leads to a result.
  const std::string precise = arithmetic_ && !f->getReturnType()->isVoidType() ? "precise " : "";
  for (std::string& parameter : list) {
    if (arithmetic_ && llvm::StringRef(parameter).startswith("inout ")) parameter = "precise " + parameter;
  }
  fresh_->declaration = precise + result + " " + fresh_->name + "(" + llvm::join(list, ", ") + ")";
  end(f);
}

std::vector<std::string> translator::parameters(const FunctionDecl* f) {
  std::vector<std::string> list;
  const auto* method = dyn_cast<CXXMethodDecl>(f);
  fresh_->signature = fresh_->name + "(";
  if (method != nullptr && !method->isStatic() && !in_storage_) {
    const std::string type = type_of(context_.getRecordType(method->getParent()), f->getLocation());
    list.push_back((method->isConst() ? "" : "inout ") + type + " self");
    fresh_->signature += type + ",";
    locals_.insert("self");
  }
  for (const ParmVarDecl* p : f->parameters()) {
    if (is_storage(p->getType())) {
      if (!p->getType()->isReferenceType()) reject(p->getLocation(), "storage by value: pass it by reference");
      fresh_->inner.emplace(p->getName(), p->getName());
      continue;
    }
    if (p->getType()->isRValueReferenceType()) reject(p->getLocation(), "rvalue reference");
    const std::string type = type_of(p->getType(), p->getLocation());
    const std::string one = p->getName().empty() ? type : declared(p, local_name(p));
    list.push_back((writes_to(p->getType()) ? "inout " : "") + one);
    fresh_->signature += type + ",";
  }
  return list;
}

void translator::translate_record(const CXXRecordDecl* r) {
  if (is_storage(r) || !begin(r)) return;
  reject_any(r->getLocation(), {{r->isUnion(), "union"},
                                {r->getNumBases() != 0, "base class"},
                                {r->isPolymorphic(), "virtual function"},
                                {r->hasUserDeclaredConstructor() || r->hasUserDeclaredDestructor(),
                                 "struct with a constructor or a destructor: only aggregates are in the subset"},
                                {r->field_empty(), "struct without members"}});
  std::string text = "struct " + fresh_->name + " {\n";
  for (const FieldDecl* f : r->fields()) {
    reject_any(f->getLocation(), {{f->isBitField(), "bit-field"},
                                  {f->getAccess() != AS_public, "member that is not public"},
                                  {f->getType()->isReferenceType(), "reference as a member"},
                                  {f->hasInClassInitializer(), "member with a default value"}});
    check_name(f->getNameAsString(), true, f->getLocation());
    fresh_->inner.emplace(f->getName(), f->getName());
    text += doc_of(f, false) + declared(f, f->getNameAsString()) + ";  " + doc_of(f, true) + "\n";
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
    fresh_->inner.emplace(c->getName(), fresh_->name + "_" + c->getName().str());
    fresh_->declaration += filled("const {0} {1}_{2} = {3}{4};  {5}\n", type, fresh_->name, c->getName(),
                                  llvm::toString(c->getInitVal(), 10), type == "uint" ? "u" : "", doc_of(c, true));
  }
  end(e);
}

void translator::translate_constant(const VarDecl* v) {
  if (!begin(v)) return;
  const Expr* init = v->getAnyInitializer();
  if (init == nullptr) {
    reject(v->getLocation(), "constant without a value");
    return;
  }
  fresh_->declaration = "const " + declared(v, fresh_->name) + " = " + glsl(init) + ";  " + doc_of(pattern_of(v), true);
  end(v);
}

}  // namespace pelage::codegen
