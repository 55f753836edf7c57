// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "model.hpp"
#include "names.hpp"
#include "translator.hpp"

#include <clang/AST/ASTConsumer.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/FrontendAction.h>
#include <clang/Lex/PPCallbacks.h>
#include <clang/Lex/Preprocessor.h>
#include <clang/Tooling/CompilationDatabase.h>
#include <clang/Tooling/Tooling.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

namespace pelage::codegen {

void problems::add(clang::SourceLocation where, const std::string& reason) {
  const clang::PresumedLoc place = sources_.getPresumedLoc(sources_.getExpansionLoc(where));
  found_.emplace(place.isValid() ? place.getFilename() : "?", place.isValid() ? place.getLine() : 0, reason);
}

void problems::print() const {
  for (const auto& [file, line, reason] : found_) {
    std::cerr << file << ":" << line << ": error: " << reason << "\n";
  }
}

namespace {

using namespace clang;

struct settings {
  std::string instantiate;
  std::string out;
  bool library = false;  ///< the headers of pelage/ are what is written, not what is there
  std::vector<std::string> compiler;
};

struct header {
  FileID file;
  std::string name;  ///< as included
  bool direct;       ///< by the instantiation file itself
};

/// Notes by which name each header was found.
class include_watcher : public PPCallbacks {
 public:
  include_watcher(SourceManager& sources, std::map<const FileEntry*, std::pair<std::string, bool>>& names)
      : sources_(sources), names_(names) {}

  void InclusionDirective(SourceLocation hash, const Token&, StringRef spelled, bool angled, CharSourceRange,
                          const FileEntry* file, StringRef, StringRef, const Module*,
                          SrcMgr::CharacteristicKind kind) override {
    if (file == nullptr || kind != SrcMgr::C_User) return;
    const bool direct = sources_.isInMainFile(hash);
    std::string name = spelled.str();
    if (!angled) {
      // Named from where the includer stands: the includer's own folder comes first.
      const FileEntry* from = sources_.getFileEntryForID(sources_.getFileID(hash));
      const auto known = names_.find(from);
      if (known != names_.end() && name.rfind("pelage/", 0) != 0) {
        name = (std::filesystem::path(known->second.first).parent_path() / name).lexically_normal().string();
      }
    }
    auto& entry = names_.try_emplace(file, name, false).first->second;
    entry.second = entry.second || direct;
  }

 private:
  SourceManager& sources_;
  std::map<const FileEntry*, std::pair<std::string, bool>>& names_;
};

class generator : public ASTConsumer {
 public:
  generator(const settings& s, SourceManager& sources, std::map<const FileEntry*, std::pair<std::string, bool>>& names,
            std::vector<std::pair<std::string, std::string>>& files, bool& failed)
      : settings_(s), sources_(sources), names_(names), files_(files), failed_(failed) {}

  void HandleTranslationUnit(ASTContext& context) override {
    if (context.getDiagnostics().hasErrorOccurred()) return;
    problems found(sources_);
    translator t(context, found, [this](FileID file) { return find(file); });
    roots(context.getTranslationUnitDecl(), t);
    t.finish();
    for (const auto& [file, u] : units_) {
      if (u && !u->mirrored && !u->entities.empty()) files_.emplace_back(u->path, file_text(*u, found));
    }
    const auto any = [this](bool unit::*uses) {
      return std::any_of(units_.begin(), units_.end(),
                         [&](const auto& u) { return u.second && (*u.second).*uses && !u.second->mirrored; });
    };
    if (any(&unit::uses_atomics)) files_.emplace_back(memory_order_path, memory_order_text());
    if (any(&unit::uses_atomic_int64)) files_.emplace_back(memory_order_64_path, memory_order_64_text());
    if (files_.empty() && found.none()) {
      std::cerr << settings_.instantiate << ": error: nothing to translate\n";
      failed_ = true;
    }
    failed_ = failed_ || !found.none();
    found.print();
  }

 private:
  /// The unit of a header of ours, or null for the rest of the world.
  unit* find(FileID file) {
    const FileEntry* entry = sources_.getFileEntryForID(file);
    const auto [place, fresh] = units_.try_emplace(entry);
    if (!fresh) return place->second.get();
    const auto named = names_.find(entry);
    const bool main = entry == sources_.getFileEntryForID(sources_.getMainFileID());
    if (!main && (named == names_.end() || sources_.isInSystemHeader(sources_.getLocForStartOfFile(file))))
      return nullptr;
    const std::string header =
        main ? std::filesystem::path(settings_.instantiate).filename().string() : named->second.first;
    if (header.rfind("glm/", 0) == 0) return nullptr;
    auto u = std::make_unique<unit>();
    u->header = header;
    const bool ours = header.rfind("pelage/", 0) == 0;
    std::filesystem::path path = ours ? header.substr(7) : header;
    u->path = path.replace_extension("glsl").string();
    if (ours && !settings_.library) {
      u->include = "pelage/glsl/" + u->path;
      u->mirrored = true;
      std::filesystem::path root = entry->tryGetRealPathName().str();
      for (std::size_t i = 0; i + 6 < header.size() && root.filename() != "pelage"; ++i)
        root = root.parent_path();
      std::ifstream in(root / "glsl" / u->path);
      u->mirror_text.assign(std::istreambuf_iterator<char>(in), {});
      if (u->mirror_text.find("_has_one_value_in_a_shader") != std::string::npos) {
        for (std::istringstream lines(u->mirror_text); lines;) {
          std::string word, macro;
          lines >> word;
          if (word == "#ifndef" && lines >> macro && macro != "PELAGE_PREFIX") u->sizes[macro];
        }
      }
    }
    place->second = std::move(u);
    return place->second.get();
  }

  /// What is translated even if no one calls it: in the headers that the instantiation file includes and in that file
  /// itself, all that is no template, and all that is explicitly instantiated.
  void roots(const DeclContext* scope, translator& t) {
    for (const Decl* d : scope->decls()) {
      if (const auto* space = dyn_cast<NamespaceDecl>(d)) {
        note_doc(space);
        roots(space, t);
        continue;
      }
      if (const auto* linkage = dyn_cast<LinkageSpecDecl>(d)) {
        if (wanted(linkage)) roots(linkage, t);
        continue;
      }
      if (!wanted(d)) continue;
      if (const auto* f = dyn_cast<FunctionDecl>(d)) {
        const bool free = f->getDescribedFunctionTemplate() == nullptr && !isa<CXXMethodDecl>(f);
        if (free && f->doesThisDeclarationHaveABody()) t.require_function(f);
      } else if (const auto* pattern = dyn_cast<FunctionTemplateDecl>(d)) {
        instantiated(pattern, t);
      } else if (const auto* classes = dyn_cast<ClassTemplateDecl>(d)) {
        for (const ClassTemplateSpecializationDecl* r : classes->specializations()) {
          if (r->getSpecializationKind() == TSK_ExplicitInstantiationDefinition) record(r, t);
        }
      } else if (isa<ClassTemplateSpecializationDecl>(d)) {
        continue;
      } else if (const auto* r = dyn_cast<CXXRecordDecl>(d)) {
        if (r->isThisDeclarationADefinition() && !translator::is_storage(r)) record(r, t);
      } else if (const auto* e = dyn_cast<EnumDecl>(d)) {
        t.require_enum(e);
      } else if (const auto* v = dyn_cast<VarDecl>(d)) {
        if (v->isConstexpr() && v->getDescribedVarTemplate() == nullptr && !isa<VarTemplateSpecializationDecl>(v)) {
          t.require_constant(v);
        }
      }
    }
  }

  void instantiated(const FunctionTemplateDecl* pattern, translator& t) {
    for (const FunctionDecl* f : pattern->specializations()) {
      if (f->getTemplateSpecializationKind() == TSK_ExplicitInstantiationDefinition) t.require_function(f);
    }
  }

  void record(const CXXRecordDecl* r, translator& t) {
    t.require_record(r);
    for (const Decl* d : r->decls()) {
      if (const auto* m = dyn_cast<CXXMethodDecl>(d)) {
        if (!m->isImplicit() && !m->isDefaulted() && !m->isDeleted() && !isa<CXXConstructorDecl>(m))
          t.require_function(m);
      } else if (const auto* pattern = dyn_cast<FunctionTemplateDecl>(d)) {
        instantiated(pattern, t);
      } else if (const auto* v = dyn_cast<VarDecl>(d)) {
        if (v->isConstexpr()) t.require_constant(v);
      } else if (const auto* e = dyn_cast<EnumDecl>(d)) {
        t.require_enum(e);
      }
    }
  }

  bool wanted(const Decl* d) {
    const FileID file = sources_.getFileID(sources_.getExpansionLoc(d->getLocation()));
    if (file == sources_.getMainFileID()) return true;
    const auto named = names_.find(sources_.getFileEntryForID(file));
    if (named == names_.end() || !named->second.second) return false;
    const unit* u = find(file);
    return u != nullptr && !u->mirrored;
  }

  /// What stands above a namespace, or by itself at its beginning, tells about the whole header.
  void note_doc(const NamespaceDecl* space) {
    if (!wanted(space)) return;
    unit* u = find(sources_.getFileID(sources_.getExpansionLoc(space->getLocation())));
    if (u == nullptr) return;
    const llvm::StringRef text = sources_.getBufferData(sources_.getFileID(space->getBeginLoc()));
    const std::size_t begin = sources_.getFileOffset(space->getBeginLoc());
    const llvm::StringRef inside = text.substr(text.find('{', begin) + 1).ltrim();
    const std::string first = doc_lines_above(inside, inside.find("\n\n") + 1);
    for (const std::string& doc : {doc_lines_above(text, begin), inside.startswith(first) ? first : std::string()}) {
      if (u->doc.find(doc) == std::string::npos) u->doc += (u->doc.empty() ? "" : "\n") + doc;
    }
  }

  const settings& settings_;
  SourceManager& sources_;
  std::map<const FileEntry*, std::pair<std::string, bool>>& names_;
  std::vector<std::pair<std::string, std::string>>& files_;
  bool& failed_;
  std::map<const FileEntry*, std::unique_ptr<unit>> units_;
};

class action : public ASTFrontendAction {
 public:
  action(const settings& s, std::vector<std::pair<std::string, std::string>>& files, bool& failed)
      : settings_(s), files_(files), failed_(failed) {}

  std::unique_ptr<ASTConsumer> CreateASTConsumer(CompilerInstance& compiler, StringRef) override {
    SourceManager& sources = compiler.getSourceManager();
    compiler.getPreprocessor().addPPCallbacks(std::make_unique<include_watcher>(sources, names_));
    return std::make_unique<generator>(settings_, sources, names_, files_, failed_);
  }

 private:
  const settings& settings_;
  std::vector<std::pair<std::string, std::string>>& files_;
  bool& failed_;
  std::map<const FileEntry*, std::pair<std::string, bool>> names_;
};

int fail(const std::string& what) {
  std::cerr << "pelage-glsl: " << what << "\n";
  return 1;
}

/// Writes all files, or none of them where one cannot be written.
int write(const std::filesystem::path& out, const std::vector<std::pair<std::string, std::string>>& files) {
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
    } else if ((a == "-I" || a == "-isystem" || a == "-D") && more) {
      s.compiler.push_back(a);
      s.compiler.push_back(arguments[++i]);
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
  std::vector<std::string> compiler = {
      "-std=c++20",    "-fsyntax-only",          "-w", "-DNDEBUG", "-DPELAGE_ASSERT(condition)=",
      "-resource-dir", PELAGE_CLANG_RESOURCE_DIR};
  compiler.insert(compiler.end(), s.compiler.begin(), s.compiler.end());
  std::ifstream source(s.instantiate);
  if (!source) return fail(s.instantiate + ": cannot be read");
  source.close();

  std::vector<std::pair<std::string, std::string>> files;
  bool failed = false;
  tooling::FixedCompilationDatabase database(".", compiler);
  tooling::ClangTool tool(database, {s.instantiate});
  tool.setPrintErrorMessage(true);
  tool.clearArgumentsAdjusters();

  struct factory : tooling::FrontendActionFactory {
    const settings& s;
    std::vector<std::pair<std::string, std::string>>& files;
    bool& failed;
    factory(const settings& a, std::vector<std::pair<std::string, std::string>>& b, bool& c)
        : s(a), files(b), failed(c) {}
    std::unique_ptr<FrontendAction> create() override { return std::make_unique<action>(s, files, failed); }
  } make(s, files, failed);
  if (tool.run(&make) != 0 || failed) return 1;

  std::sort(files.begin(), files.end());
  if (s.library) files.emplace_back("../glsl.hpp", strings_header(files));
  return write(s.out, files);
}

}  // namespace

}  // namespace pelage::codegen

int main(int argc, char** argv) {
  return pelage::codegen::run(std::vector<std::string>(argv + 1, argv + argc));
}
