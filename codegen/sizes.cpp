// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// A template's size is a macro in GLSL, by which a shader picks its own.
#include "names.hpp"
#include "translator.hpp"

namespace pelage::codegen {

using namespace clang;

namespace {

bool is_size(const NamedDecl* parameter) {
  const auto* value = dyn_cast<NonTypeTemplateParmDecl>(parameter);
  return value != nullptr && value->getType()->isIntegerType() && !value->getType()->isBooleanType();
}

/// A template and what it is instantiated with, or nothing.
struct specialization {
  const TemplateDecl* of = nullptr;
  llvm::ArrayRef<TemplateArgument> arguments;
};

specialization specialization_of(const Decl* d) {
  if (const auto* r = dyn_cast_or_null<ClassTemplateSpecializationDecl>(d)) {
    return {r->getSpecializedTemplate(), r->getTemplateArgs().asArray()};
  }
  const auto* f = dyn_cast_or_null<FunctionDecl>(d);
  if (f == nullptr || f->getPrimaryTemplate() == nullptr) return {};
  return {f->getPrimaryTemplate(), f->getTemplateSpecializationArgs()->asArray()};
}

/// A template's parameter.
struct parameter {
  const TemplateDecl* of;
  unsigned index;
  [[nodiscard]] const NamedDecl* declaration() const { return of->getTemplateParameters()->getParam(index); }
};

/// Whose size a template's is: template <int K> f(const list<K>&) has that of list; other templates have their own.
parameter owner_of(const TemplateDecl* t, unsigned index) {
  const parameter own = {cast<TemplateDecl>(t->getCanonicalDecl()), index};
  const auto* f = dyn_cast<FunctionDecl>(own.of->getTemplatedDecl());
  if (f == nullptr) return own;
  std::vector<QualType> types = {f->getReturnType()};
  for (const ParmVarDecl* p : f->parameters())
    types.push_back(p->getType());
  for (const QualType& type : types) {
    const auto* written = type.getNonReferenceType()->getAs<TemplateSpecializationType>();
    const auto* of = written == nullptr ? nullptr : written->getTemplateName().getAsTemplateDecl();
    if (of == nullptr || of->isInStdNamespace() || !isa<ClassTemplateDecl>(of)) continue;
    for (unsigned i = 0; i < written->getNumArgs(); ++i) {
      if (written->getArg(i).getKind() != TemplateArgument::Expression) continue;
      const auto* named = dyn_cast<DeclRefExpr>(written->getArg(i).getAsExpr()->IgnoreImplicit());
      if (named != nullptr && named->getDecl() == own.declaration()) return {of, i};
    }
  }
  return own;
}

/// A function's size bears the name of the struct beside it in the header that has one of this name, else that of its
/// namespace where that is one structure's own; any other template's its own.
std::string macro_name(const parameter& size) {
  const llvm::StringRef name = size.declaration()->getName();
  const auto* space = dyn_cast<NamespaceDecl>(size.of->getDeclContext());
  const NamedDecl* bearer = size.of->getTemplatedDecl();
  if (isa<FunctionTemplateDecl>(size.of) && space != nullptr) {
    if (isa<NamespaceDecl>(space->getDeclContext()) && !space->isInline()) bearer = space;
    for (const Decl* d : space->decls()) {
      const auto* beside = dyn_cast<ClassTemplateDecl>(d);
      if (beside != nullptr && llvm::any_of(*beside->getTemplateParameters(),
                                            [&](const NamedDecl* p) { return is_size(p) && p->getName() == name; })) {
        bearer = beside->getTemplatedDecl();
      }
    }
  }
  return llvm::StringRef(global_name(bearer) + "_" + name.str()).upper();
}

std::string macro_name(const TemplateDecl* t, unsigned index) {
  return macro_name(owner_of(t, index));
}

}  // namespace

/// A use of a template's parameter: its macro.
std::string translator::size_name(const NonTypeTemplateParmDecl* p, SourceLocation where) {
  if (!is_size(p)) return reject(where, "template parameter `" + p->getNameAsString() + "` is not an integer");
  // A parameter knows its template, except where a member is defined outside of its class.
  const TemplateDecl* owner = Decl::castFromDeclContext(p->getDeclContext())->getDescribedTemplate();
  if (owner == nullptr && p->getDepth() < templates_.size()) owner = templates_[p->getDepth()];
  if (owner == nullptr) {
    return reject(where, "the size `" + p->getNameAsString() + "` is lost here: name it where it is declared");
  }
  return *fresh_->sizes.insert(macro_name(owner, p->getIndex())).first;
}

/// Records the templates round a definition, outermost first, and what their sizes are in this instantiation: the first
/// one gives the macro's default, all are counted, since two must come out alike. The sizes of a type that is a
/// template's argument are the template's too.
void translator::set_templates(const Decl* d) {
  templates_.clear();
  size_values_.clear();
  std::vector<const Decl*> chain = {d};
  for (const DeclContext* c = d->getDeclContext(); c != nullptr && c->isRecord(); c = c->getParent()) {
    chain.insert(chain.begin(), cast<Decl>(c));
  }
  for (const Decl* level : chain) {
    const specialization s = specialization_of(level);
    if (s.of == nullptr) continue;
    templates_.push_back(s.of);
    std::string values;
    const std::function<void(const specialization&)> note = [&](const specialization& one) {
      for (unsigned i = 0; i < one.arguments.size(); ++i) {
        const parameter size = owner_of(one.of, i);
        if (is_size(size.declaration())) {
          const llvm::APSInt value = one.arguments[i].getAsIntegral();
          fresh_->inner.emplace(one.of->getTemplateParameters()->getParam(i)->getName(), macro_name(size));
          size_values_.emplace_back(macro_name(size), value);
          values += llvm::toString(value, 10) + " ";
          if (unit* u = headers_.unit_of(file(size.of->getLocation()))) {
            u->sizes.try_emplace(macro_name(size), llvm::toString(value, 10));
          }
        } else if (one.arguments[i].getKind() == TemplateArgument::Type) {
          const specialization type = specialization_of(one.arguments[i].getAsType()->getAsCXXRecordDecl());
          if (type.of != nullptr && headers_.unit_of(file(type.of->getLocation())) != nullptr) note(type);
        }
      }
    };
    note(s);
    if (!values.empty()) sizes_seen_[s.of->getQualifiedNameAsString()].try_emplace(values, level->getLocation());
  }
}

/// A static_assert over sizes becomes an #error in the mirror.
void translator::note_condition(const StaticAssertDecl* check) {
  if (check->getMessage() == nullptr || !has_size(check->getAssertExpr())) return;
  const std::set<std::string> before = std::exchange(fresh_->sizes, {});
  const std::string text = preprocessed(glsl(check->getAssertExpr()->IgnoreImplicit()));
  std::vector<condition>& all = fresh_->where->conditions;
  if (llvm::none_of(all, [&](const condition& c) { return c.text == text; })) {
    all.push_back({fresh_->sizes, text, check->getMessage()->getString().str()});
  }
  fresh_->sizes.insert(before.begin(), before.end());
}

/// What the sizes of something used here are, in terms of the sizes here: as written in `f<2u * K>`, else the size here
/// of the same value. The second instantiation shows whether that guess was right.
void translator::bind_sizes(const Decl* used, llvm::ArrayRef<TemplateArgument> written) {
  const specialization s = specialization_of(used);
  for (unsigned i = 0; i < s.arguments.size(); ++i) {
    if (!is_size(s.of->getTemplateParameters()->getParam(i))) continue;
    const std::string name = macro_name(s.of, i);
    std::string text = llvm::toString(s.arguments[i].getAsIntegral(), 10);
    for (const auto& [mine, size] : size_values_) {
      if (text != name && llvm::APSInt::isSameValue(size, s.arguments[i].getAsIntegral())) text = mine;
    }
    if (i < written.size() && written[i].getKind() == TemplateArgument::Expression) {
      text = size_expression(written[i].getAsExpr());
    }
    if (text.find(' ') != std::string::npos) text = "(" + text + ")";
    if (text != name) fresh_->bindings[name] = text;
  }
}

}  // namespace pelage::codegen
