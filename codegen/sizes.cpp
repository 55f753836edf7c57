// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "names.hpp"
#include "translator.hpp"

namespace pelage::codegen {

using namespace clang;

namespace {

std::string macro_name(const TemplateDecl* t, unsigned index) {
  const auto* first = cast<TemplateDecl>(t->getCanonicalDecl());
  return upper(global_name(first->getTemplatedDecl()) + "_" +
               first->getTemplateParameters()->getParam(index)->getNameAsString());
}

bool is_size(const NamedDecl* parameter) {
  const auto* value = dyn_cast<NonTypeTemplateParmDecl>(parameter);
  return value != nullptr && value->getType()->isIntegerType() && !value->getType()->isBooleanType();
}

const TemplateArgumentList* arguments_of(const Decl* d, const TemplateDecl*& pattern) {
  if (const auto* r = dyn_cast<ClassTemplateSpecializationDecl>(d)) {
    pattern = r->getSpecializedTemplate();
    return &r->getTemplateArgs();
  }
  if (const auto* f = dyn_cast<FunctionDecl>(d); f != nullptr && f->getPrimaryTemplate() != nullptr) {
    pattern = f->getPrimaryTemplate();
    return f->getTemplateSpecializationArgs();
  }
  return nullptr;
}

}  // namespace

/// A use of a template's parameter: its macro.
std::string translator::size_name(const NonTypeTemplateParmDecl* p, SourceLocation where) {
  if (!is_size(p)) return reject(where, "template parameter `" + p->getNameAsString() + "` is not an integer");
  if (p->getDepth() >= templates_.size()) {
    return reject(where, "the size `" + p->getNameAsString() + "` is lost here: name it where it is declared");
  }
  const std::string name = macro_name(templates_[p->getDepth()], p->getIndex());
  if (fresh_) fresh_->sizes.insert(name);
  return name;
}

/// Records the templates round a definition, outermost first, and what their sizes are in this instantiation.
void translator::set_templates(const Decl* d) {
  templates_.clear();
  size_values_.clear();
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

/// The first instantiation gives the macro's default; all are counted, since two must come out alike.
void translator::note_sizes(const NamedDecl* owner, const TemplateDecl* pattern, const TemplateArgumentList& arguments) {
  std::string values;
  for (unsigned i = 0; i < arguments.size(); ++i) {
    const NamedDecl* parameter = pattern->getTemplateParameters()->getParam(i);
    if (!is_size(parameter)) continue;
    const std::string name = macro_name(pattern, i);
    const std::string value = llvm::toString(arguments[i].getAsIntegral(), 10);
    size_values_.emplace_back(name, arguments[i].getAsIntegral());
    values += value + " ";
    if (unit* u = unit_of_(sources_.getFileID(sources_.getExpansionLoc(pattern->getLocation())))) {
      u->sizes.try_emplace(name, size_macro{value, {}});
    }
  }
  if (!values.empty()) {
    const std::string name = pattern->getQualifiedNameAsString();
    sizes_seen_[name].insert(values);
    size_places_.try_emplace(name, owner->getLocation());
  }
}

/// static_assert over sizes alone becomes an #error in the mirror.
void translator::record_conditions(const CXXRecordDecl* r, unit& u) {
  for (const Decl* d : r->decls()) {
    const auto* check = dyn_cast<StaticAssertDecl>(d);
    if (check == nullptr || size_values_.empty() || check->getMessage() == nullptr) continue;
    size_macro& size = u.sizes[size_values_.front().first];
    if (!size.conditions.empty()) continue;
    std::string condition = expression(check->getAssertExpr()->IgnoreImplicit());
    for (std::size_t i = condition.find('u'); i != std::string::npos; i = condition.find('u', i + 1)) {
      if (i > 0 && isdigit(static_cast<unsigned char>(condition[i - 1])) != 0) condition.erase(i, 1);
    }
    size.conditions.emplace_back(condition, check->getMessage()->getString().str());
  }
}

/// What a callee's sizes are, in the caller's terms: as written in `f<2u * K>`, else the caller's size of the same
/// value. The second instantiation shows whether that guess was right.
void translator::bind_sizes(const FunctionDecl* callee, const Expr* call) {
  std::vector<const Decl*> chain = {callee};
  if (const auto* m = dyn_cast<CXXMethodDecl>(callee)) chain.push_back(m->getParent());
  const auto* written = call == nullptr ? nullptr : dyn_cast<DeclRefExpr>(call->IgnoreParenImpCasts());
  for (const Decl* level : chain) {
    const TemplateDecl* pattern = nullptr;
    const TemplateArgumentList* arguments = arguments_of(level, pattern);
    if (arguments == nullptr) continue;
    for (unsigned i = 0; i < arguments->size(); ++i) {
      if (!is_size(pattern->getTemplateParameters()->getParam(i))) continue;
      const llvm::APSInt value = (*arguments)[i].getAsIntegral();
      std::string text = llvm::toString(value, 10);
      for (const auto& [name, mine] : size_values_) {
        if (llvm::APSInt::isSameValue(mine, value)) text = name;
      }
      if (level == callee && written != nullptr && i < written->getNumTemplateArgs()) {
        const TemplateArgument& argument = written->template_arguments()[i].getArgument();
        if (argument.getKind() == TemplateArgument::Expression) text = expression(argument.getAsExpr());
      }
      const std::string name = macro_name(pattern, i);
      if (text.find(' ') != std::string::npos) text = "(" + text + ")";
      if (fresh_ && text != name) fresh_->bindings[name] = text;
    }
  }
}

}  // namespace pelage::codegen
