// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "names.hpp"
#include "translator.hpp"

namespace pelage::codegen {

using namespace clang;

namespace {

bool is_size(const NamedDecl* parameter) {
  const auto* value = dyn_cast<NonTypeTemplateParmDecl>(parameter);
  return value != nullptr && value->getType()->isIntegerType() && !value->getType()->isBooleanType();
}

/// Whose size a template's parameter `name` is: a function's is that of the struct beside it in the header that has one
/// of this name, else that of its namespace where that is one structure's own; any other template's is its own.
const NamedDecl* owner_of_size(const TemplateDecl* t, llvm::StringRef name) {
  const auto* space = dyn_cast<NamespaceDecl>(t->getDeclContext());
  if (!isa<FunctionTemplateDecl>(t) || space == nullptr) return t->getTemplatedDecl();
  for (const Decl* d : space->decls()) {
    const auto* beside = dyn_cast<ClassTemplateDecl>(d);
    if (beside == nullptr) continue;
    for (const NamedDecl* p : *beside->getTemplateParameters()) {
      if (is_size(p) && p->getName() == name) return beside->getTemplatedDecl();
    }
  }
  return isa<NamespaceDecl>(space->getDeclContext()) ? cast<NamedDecl>(space) : t->getTemplatedDecl();
}

std::string macro_name(const TemplateDecl* t, unsigned index) {
  const auto* first = cast<TemplateDecl>(t->getCanonicalDecl());
  const std::string name = first->getTemplateParameters()->getParam(index)->getNameAsString();
  return upper(global_name(owner_of_size(first, name)) + "_" + name);
}

const TemplateArgumentList* arguments_of(const Decl* d, const TemplateDecl*& pattern) {
  if (const auto* r = dyn_cast_or_null<ClassTemplateSpecializationDecl>(d)) {
    pattern = r->getSpecializedTemplate();
    return &r->getTemplateArgs();
  }
  if (const auto* f = dyn_cast_or_null<FunctionDecl>(d); f != nullptr && f->getPrimaryTemplate() != nullptr) {
    pattern = f->getPrimaryTemplate();
    return f->getTemplateSpecializationArgs();
  }
  return nullptr;
}

}  // namespace

/// A use of a template's parameter: its macro.
std::string translator::size_name(const NonTypeTemplateParmDecl* p, SourceLocation where) {
  if (!is_size(p)) return reject(where, "template parameter `" + p->getNameAsString() + "` is not an integer");
  // A parameter knows its template, except where a member is defined outside of its class.
  const TemplateDecl* owner = p->getDepth() < templates_.size() ? templates_[p->getDepth()] : nullptr;
  if (const auto* f = dyn_cast<FunctionDecl>(p->getDeclContext()); f != nullptr && f->getDescribedFunctionTemplate()) {
    owner = f->getDescribedFunctionTemplate();
  } else if (const auto* r = dyn_cast<CXXRecordDecl>(p->getDeclContext());
             r != nullptr && r->getDescribedClassTemplate()) {
    owner = r->getDescribedClassTemplate();
  }
  if (owner == nullptr) {
    return reject(where, "the size `" + p->getNameAsString() + "` is lost here: name it where it is declared");
  }
  std::string name = macro_name(owner, p->getIndex());
  if (const auto alias = aliases_.find(name); alias != aliases_.end()) name = alias->second;
  if (fresh_) fresh_->sizes.insert(name);
  return name;
}

/// template <int K> f(const list<K>&): the size of f is that of list, and needs no macro of its own.
void translator::find_aliases(const FunctionDecl* f) {
  const FunctionTemplateDecl* own = f->getPrimaryTemplate();
  if (own == nullptr) return;
  std::vector<QualType> types = {f->getReturnType()};
  for (const ParmVarDecl* p : f->parameters())
    types.push_back(p->getType());
  for (const QualType& type : types) {
    const auto* written = type.getNonReferenceType()->getAs<TemplateSpecializationType>();
    const auto* of = written == nullptr ? nullptr : written->getTemplateName().getAsTemplateDecl();
    if (of == nullptr || of->isInStdNamespace() || !isa<ClassTemplateDecl>(of)) continue;
    for (unsigned i = 0; i < written->getNumArgs(); ++i) {
      if (written->getArg(i).getKind() != TemplateArgument::Expression) continue;
      const auto* size = dyn_cast<SubstNonTypeTemplateParmExpr>(without_conversions(written->getArg(i).getAsExpr()));
      if (size == nullptr || !is_size(of->getTemplateParameters()->getParam(i))) continue;
      aliases_.try_emplace(macro_name(own, size->getParameter()->getIndex()), macro_name(of, i));
    }
  }
}

/// Records the templates round a definition, outermost first, and what their sizes are in this instantiation.
void translator::set_templates(const Decl* d) {
  templates_.clear();
  size_values_.clear();
  aliases_.clear();
  if (const auto* f = dyn_cast<FunctionDecl>(d)) find_aliases(f);
  std::vector<const Decl*> chain = {d};
  for (const DeclContext* c = d->getDeclContext(); c != nullptr && c->isRecord(); c = c->getParent()) {
    chain.insert(chain.begin(), cast<Decl>(c));
  }
  for (const Decl* level : chain) {
    const TemplateDecl* pattern = nullptr;
    const TemplateArgumentList* arguments = arguments_of(level, pattern);
    if (arguments == nullptr) continue;
    templates_.push_back(pattern);
    note_sizes(cast<NamedDecl>(level), pattern, *arguments);
  }
}

/// The first instantiation gives the macro's default; all are counted, since two must come out alike. The sizes of a
/// type that is a template's argument are the template's too.
void translator::note_sizes(const NamedDecl* owner, const TemplateDecl* pattern,
                            const TemplateArgumentList& arguments) {
  std::string values;
  for (unsigned i = 0; i < arguments.size(); ++i) {
    if (arguments[i].getKind() == TemplateArgument::Type) {
      const TemplateDecl* of = nullptr;
      const TemplateArgumentList* sizes = arguments_of(arguments[i].getAsType()->getAsCXXRecordDecl(), of);
      const bool ours = sizes != nullptr && unit_of_(file(of->getLocation()));
      for (unsigned j = 0; ours && j < sizes->size(); ++j) {
        if (!is_size(of->getTemplateParameters()->getParam(j))) continue;
        size_values_.emplace_back(macro_name(of, j), (*sizes)[j].getAsIntegral());
        values += llvm::toString((*sizes)[j].getAsIntegral(), 10) + " ";
      }
      continue;
    }
    const NamedDecl* parameter = pattern->getTemplateParameters()->getParam(i);
    if (!is_size(parameter)) continue;
    std::string name = macro_name(pattern, i);
    const auto alias = aliases_.find(name);
    if (alias != aliases_.end()) name = alias->second;
    const std::string value = llvm::toString(arguments[i].getAsIntegral(), 10);
    size_values_.emplace_back(name, arguments[i].getAsIntegral());
    values += value + " ";
    if (alias != aliases_.end()) continue;
    if (unit* u = unit_of_(file(pattern->getLocation()))) {
      u->sizes.try_emplace(name, value);
    }
  }
  if (!values.empty()) {
    const std::string name = pattern->getQualifiedNameAsString();
    sizes_seen_[name].insert(values);
    size_places_.try_emplace(name, owner->getLocation());
  }
}

/// A static_assert over sizes becomes an #error in the mirror.
void translator::note_condition(const StaticAssertDecl* check) {
  if (check->getMessage() == nullptr || !has_size(check->getAssertExpr())) return;
  std::string condition = glsl(check->getAssertExpr()->IgnoreImplicit());
  for (std::size_t i = condition.find('u'); i != std::string::npos; i = condition.find('u', i + 1)) {
    if (i > 0 && isdigit(static_cast<unsigned char>(condition[i - 1])) != 0) condition.erase(i, 1);
  }
  fresh_->where->conditions.emplace(condition, check->getMessage()->getString().str());
}

/// What the size of something used here is, in terms of the sizes here: as written in `f<2u * K>`, else the size here
/// of the same value. The second instantiation shows whether that guess was right.
void translator::bind_size(const TemplateDecl* of, unsigned index, const TemplateArgument& value,
                           const TemplateArgument* written) {
  if (!fresh_ || !is_size(of->getTemplateParameters()->getParam(index))) return;
  const std::string name = macro_name(of, index);
  std::string text = llvm::toString(value.getAsIntegral(), 10);
  for (const auto& [mine, size] : size_values_) {
    if (text != name && llvm::APSInt::isSameValue(size, value.getAsIntegral())) text = mine;
  }
  if (written != nullptr && written->getKind() == TemplateArgument::Expression) {
    text = size_expression(written->getAsExpr());
  }
  if (text.find(' ') != std::string::npos) text = "(" + text + ")";
  if (text != name) fresh_->bindings[name] = text;
}

void translator::bind_sizes(const FunctionDecl* callee, const Expr* call) {
  std::vector<const Decl*> chain = {callee};
  if (const auto* m = dyn_cast<CXXMethodDecl>(callee)) chain.push_back(m->getParent());
  const auto* written = call == nullptr ? nullptr : dyn_cast<DeclRefExpr>(call->IgnoreParenImpCasts());
  // A size that is a parameter's is bound with the parameter's type.
  std::map<std::string, std::string> own;
  own.swap(aliases_);
  find_aliases(callee);
  aliases_.swap(own);
  for (const Decl* level : chain) {
    const TemplateDecl* pattern = nullptr;
    const TemplateArgumentList* arguments = arguments_of(level, pattern);
    for (unsigned i = 0; arguments != nullptr && i < arguments->size(); ++i) {
      if (own.count(macro_name(pattern, i)) != 0) continue;
      const bool named = level == callee && written != nullptr && i < written->getNumTemplateArgs();
      bind_size(pattern, i, (*arguments)[i], named ? &written->template_arguments()[i].getArgument() : nullptr);
    }
  }
}

void translator::bind_sizes(QualType t) {
  const TemplateDecl* pattern = nullptr;
  const CXXRecordDecl* record = t->getAsCXXRecordDecl();
  const TemplateArgumentList* arguments = arguments_of(record, pattern);
  const auto* written = t->getAs<TemplateSpecializationType>();
  for (unsigned i = 0; arguments != nullptr && i < arguments->size(); ++i) {
    const bool named = written != nullptr && i < written->getNumArgs();
    bind_size(pattern, i, (*arguments)[i], named ? &written->getArg(i) : nullptr);
  }
}

}  // namespace pelage::codegen
