// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "translator.hpp"

#include <clang/Tooling/Tooling.h>
#include <llvm/ADT/TypeSwitch.h>
#include <llvm/Support/CommandLine.h>

#include <filesystem>
#include <fstream>
#include <iostream>

namespace pelage::codegen {

namespace {

/// What is translated even if no one calls it: in the headers that the instantiation file includes and in that file
/// itself, all that is no template, and all that is explicitly instantiated.
void require_roots(const clang::DeclContext* scope, headers& all, translator& t) {
  using namespace clang;
  const auto require = [&](const NamedDecl* d) {
    t.require(d);
    if (const auto* r = dyn_cast<CXXRecordDecl>(d)) require_roots(r, all, t);
  };
  for (const Decl* d : scope->decls()) {
    if (const auto* space = dyn_cast<NamespaceDecl>(d)) all.note_doc(space);
    if (isa<NamespaceDecl, LinkageSpecDecl>(d)) require_roots(cast<DeclContext>(d), all, t);
    if (d->isImplicit() || !all.is_named(d)) continue;
    llvm::TypeSwitch<const Decl*>(d)
        .Case<FunctionTemplateDecl, ClassTemplateDecl>([&](const auto* pattern) {
          for (const auto* s : pattern->specializations()) {
            if (s->getTemplateSpecializationKind() == TSK_ExplicitInstantiationDefinition) require(s);
          }
        })
        .Case<ClassTemplateSpecializationDecl, VarTemplateSpecializationDecl>([](const auto*) {})
        .Case<CXXRecordDecl>([&](const auto* r) {
          if (r->isThisDeclarationADefinition() && !translator::is_storage(r)) require(r);
        })
        .Case<FunctionDecl>([&](const auto* f) {
          const bool special = f->isDefaulted() || f->isDeleted() || isa<CXXConstructorDecl>(f);
          const bool defined = scope->isRecord() ? f->isDefined() : f->doesThisDeclarationHaveABody();
          if (f->getDeclContext() == scope && defined && !special) require(f);
        })
        .Case<VarDecl>([&](const auto* v) {
          if (v->isConstexpr() && v->getDescribedVarTemplate() == nullptr) require(v);
        })
        .Case<EnumDecl>([&](const auto* e) { require(e); });
  }
}

/// Every file of the mirror. False, and every reason on stderr, where one cannot be written.
bool translate(clang::ASTUnit& ast, bool library, texts& files) {
  problems found(ast.getSourceManager());
  headers all(ast.getPreprocessor(), library);
  translator t(ast.getASTContext(), all, found);
  require_roots(ast.getASTContext().getTranslationUnitDecl(), all, t);
  t.finish();
  const glossary words = {t.names(), all.mirrored()};
  for (const unit* u : all.written()) {
    files[u->path] = file_text(*u, words, found);
    for (const std::string& path : u->memory_orders)
      files[path] = memory_order_text(path);
  }
  if (found.report()) return false;
  if (files.empty()) std::cerr << ast.getMainFileName().str() << ": error: nothing to translate\n";
  return !files.empty();
}

/// Writes all files, or none of them where one cannot be written.
bool write(const std::filesystem::path& out, const texts& files) {
  namespace fs = std::filesystem;
  std::error_code error;
  std::string failed;
  const auto path_of = [&](const std::string& name) { return (out / name).lexically_normal().string(); };
  for (const auto& [name, text] : files) {
    fs::create_directories(fs::path(path_of(name)).parent_path(), error);
    if (!(std::ofstream(path_of(name) + ".new", std::ios::binary) << text << std::flush)) failed = path_of(name);
  }
  for (const auto& [name, text] : files) {
    if (failed.empty()) fs::rename(path_of(name) + ".new", path_of(name), error);
    if (failed.empty() && error) failed = path_of(name);
    fs::remove(path_of(name) + ".new", error);
  }
  if (!failed.empty()) std::cerr << "pelage-glsl: " << failed << ": cannot be written\n";
  return failed.empty();
}

}  // namespace

}  // namespace pelage::codegen

int main(int argc, char** argv) {
  using namespace pelage::codegen;
  namespace cl = llvm::cl;
  cl::OptionCategory ours("Options");
  const cl::opt<std::string> instantiate("instantiate", cl::Required, cl::desc("what is to be translated"),
                                         cl::value_desc("FILE.cpp"), cl::cat(ours));
  const cl::opt<std::string> out("out", cl::Required, cl::desc("where the .glsl files go"), cl::value_desc("FOLDER"),
                                 cl::cat(ours));
  const cl::opt<bool> library("library", cl::desc("write the library's own mirror"), cl::cat(ours));
  const cl::list<std::string> folders("I", cl::Prefix, cl::desc("where headers lie"), cl::value_desc("FOLDER"),
                                      cl::cat(ours));
  cl::HideUnrelatedOptions(ours);
  cl::ParseCommandLineOptions(argc, argv, "The GLSL of what FILE.cpp instantiates: one .glsl for each header.\n");

  std::vector<std::string> compiler = {"-std=c++20", "-w", "-DNDEBUG",
                                       "-DPELAGE_ASSERT(condition)=static_assert(true)"};
  compiler.insert(compiler.end(),
                  {"-resource-dir", PELAGE_CLANG_RESOURCE_DIR, "-Xclang", "-detailed-preprocessing-record"});
  for (const std::string& folder : folders)
    compiler.push_back("-I" + folder);
  const auto source = llvm::MemoryBuffer::getFile(instantiate);
  if (!source) {
    std::cerr << "pelage-glsl: " << instantiate << ": cannot be read\n";
    return 1;
  }
  const auto ast = clang::tooling::buildASTFromCodeWithArgs((*source)->getBuffer(), compiler, instantiate);
  texts files;
  if (ast == nullptr || ast->getDiagnostics().hasErrorOccurred() || !translate(*ast, library, files)) return 1;
  return write(out.getValue(), files) ? 0 : 1;
}
