// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "headers.hpp"
#include "translator.hpp"

#include <clang/Tooling/Tooling.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace pelage::codegen {

namespace {

struct settings {
  std::string instantiate;
  std::string out;
  bool library = false;  ///< the headers of pelage/ are what is written, not what is there
  std::vector<std::string> compiler;
};

using texts = std::vector<std::pair<std::string, std::string>>;  ///< of files, by path

int fail(const std::string& what) {
  std::cerr << "pelage-glsl: " << what << "\n";
  return 1;
}

/// What is translated even if no one calls it: in the headers that the instantiation file includes and in that file
/// itself, all that is no template, and all that is explicitly instantiated.
void require_roots(const clang::DeclContext* scope, headers& all, translator& t) {
  using namespace clang;
  for (const Decl* d : scope->decls()) {
    if (const auto* space = dyn_cast<NamespaceDecl>(d)) {
      all.note_doc(space);
      require_roots(space, all, t);
    } else if (d->isImplicit() || !all.is_named(d)) {
      continue;
    } else if (const auto* linkage = dyn_cast<LinkageSpecDecl>(d)) {
      require_roots(linkage, all, t);
    } else if (const auto* functions = dyn_cast<FunctionTemplateDecl>(d)) {
      for (const FunctionDecl* f : functions->specializations()) {
        if (f->getTemplateSpecializationKind() == TSK_ExplicitInstantiationDefinition) t.require(f);
      }
    } else if (const auto* classes = dyn_cast<ClassTemplateDecl>(d)) {
      for (const ClassTemplateSpecializationDecl* r : classes->specializations()) {
        if (r->getSpecializationKind() != TSK_ExplicitInstantiationDefinition) continue;
        t.require(r);
        require_roots(r, all, t);
      }
    } else if (isa<ClassTemplateSpecializationDecl>(d) || isa<VarTemplateSpecializationDecl>(d)) {
      continue;
    } else if (const auto* r = dyn_cast<CXXRecordDecl>(d)) {
      if (!r->isThisDeclarationADefinition() || translator::is_storage(r)) continue;
      t.require(r);
      require_roots(r, all, t);
    } else if (const auto* f = dyn_cast<FunctionDecl>(d)) {
      const bool special = f->isDefaulted() || f->isDeleted() || isa<CXXConstructorDecl>(f);
      const bool defined = scope->isRecord() ? f->isDefined() : f->doesThisDeclarationHaveABody();
      if (f->getDeclContext() == scope && defined && !special) t.require(f);
    } else if (const auto* v = dyn_cast<VarDecl>(d)) {
      if (v->isConstexpr() && v->getDescribedVarTemplate() == nullptr) t.require(v);
    } else if (const auto* e = dyn_cast<EnumDecl>(d)) {
      t.require(e);
    }
  }
}

/// Every file of the mirror. False, and every reason on stderr, where one cannot be written.
bool translate(clang::ASTUnit& ast, const settings& s, texts& files) {
  problems found(ast.getSourceManager());
  headers all(ast, s.library);
  translator t(ast.getASTContext(), found, [&](clang::FileID file) { return all.unit_of(file); });
  require_roots(ast.getASTContext().getTranslationUnitDecl(), all, t);
  t.finish();
  bool atomics = false;
  bool wide_atomics = false;
  for (const unit* u : all.written()) {
    files.emplace_back(u->path, file_text(*u, found));
    atomics |= u->uses_atomics;
    wide_atomics |= u->uses_atomic_int64;
  }
  if (atomics) files.emplace_back(memory_order_path, memory_order_text());
  if (wide_atomics) files.emplace_back(memory_order_64_path, memory_order_64_text());
  std::sort(files.begin(), files.end());
  found.print();
  if (files.empty() && found.none()) std::cerr << s.instantiate << ": error: nothing to translate\n";
  return !files.empty() && found.none();
}

/// Writes all files, or none of them where one cannot be written.
int write(const std::filesystem::path& out, const texts& files) {
  namespace fs = std::filesystem;
  std::error_code error;
  std::vector<std::pair<fs::path, fs::path>> moves;
  for (const auto& [name, text] : files) {
    const fs::path path = (out / name).lexically_normal();
    const fs::path fresh = path.string() + ".new";
    fs::create_directories(path.parent_path(), error);
    std::ofstream stream(fresh, std::ios::binary);
    stream << text;
    stream.close();
    moves.emplace_back(fresh, path);
    if (!stream) {
      for (const auto& [from, to] : moves)
        fs::remove(from, error);
      return fail(path.string() + ": cannot be written");
    }
  }
  for (const auto& [from, to] : moves)
    fs::rename(from, to, error);
  return error ? fail(out.string() + ": " + error.message()) : 0;
}

int run(const std::vector<std::string>& arguments) {
  settings s;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& a = arguments[i];
    const bool more = i + 1 < arguments.size();
    if (a == "--instantiate" && more) {
      s.instantiate = arguments[++i];
    } else if (a == "--out" && more) {
      s.out = arguments[++i];
    } else if (a == "--library") {
      s.library = true;
    } else if ((a == "-I" || a == "-D") && more) {
      s.compiler.push_back(a + arguments[++i]);
    } else if (a.rfind("-I", 0) == 0 || a.rfind("-D", 0) == 0) {
      s.compiler.push_back(a);
    } else {
      return fail("unknown argument " + a);
    }
  }
  if (s.instantiate.empty() || s.out.empty()) {
    std::cerr << "usage: pelage-glsl --instantiate FILE.cpp --out FOLDER [-I FOLDER]... [-D MACRO]...\n"
                 "Writes the GLSL of what FILE.cpp instantiates, one .glsl for each header, below FOLDER.\n";
    return 2;
  }
  std::ifstream source(s.instantiate);
  const std::string text(std::istreambuf_iterator<char>(source), {});
  if (!source) return fail(s.instantiate + ": cannot be read");
  std::vector<std::string> compiler = {"-std=c++20",
                                       "-fsyntax-only",
                                       "-w",
                                       "-DNDEBUG",
                                       "-DPELAGE_ASSERT(condition)=static_assert(true)",
                                       "-resource-dir",
                                       PELAGE_CLANG_RESOURCE_DIR,
                                       "-Xclang",
                                       "-detailed-preprocessing-record"};
  compiler.insert(compiler.end(), s.compiler.begin(), s.compiler.end());
  const auto ast = clang::tooling::buildASTFromCodeWithArgs(text, compiler, s.instantiate, "pelage-glsl");
  if (ast == nullptr || ast->getDiagnostics().hasErrorOccurred()) return 1;
  texts files;
  if (!translate(*ast, s, files)) return 1;
  if (s.library) files.emplace_back("../glsl.hpp", strings_header(files));
  return write(s.out, files);
}

}  // namespace

}  // namespace pelage::codegen

int main(int argc, char** argv) {
  return pelage::codegen::run(std::vector<std::string>(argv + 1, argv + argc));
}
