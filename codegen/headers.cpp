// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "model.hpp"
#include "names.hpp"

#include <clang/Lex/HeaderSearch.h>
#include <clang/Lex/PreprocessingRecord.h>
#include <clang/Lex/Preprocessor.h>

#include <llvm/Support/Regex.h>

#include <filesystem>

namespace pelage::codegen {

using namespace clang;

headers::headers(Preprocessor& preprocessor, bool library)
    : preprocessor_(preprocessor), sources_(preprocessor.getSourceManager()), library_(library) {
  for (const PreprocessedEntity* entity : *preprocessor.getPreprocessingRecord()) {
    const auto* include = dyn_cast<InclusionDirective>(entity);
    if (include != nullptr && sources_.isInMainFile(entity->getSourceRange().getBegin())) {
      named_.insert(include->getFile());
    }
  }
}

unit* headers::unit_of(FileID file, bool wide) {
  const FileEntry* entry = sources_.getFileEntryForID(file);
  const auto [place, fresh] = units_.try_emplace({entry, wide});
  if (!fresh || entry == nullptr) return place->second.get();
  const bool main = file == sources_.getMainFileID();
  const llvm::StringRef main_name = sources_.getFileEntryForID(sources_.getMainFileID())->getName();
  if (!main && sources_.isInSystemHeader(sources_.getLocForStartOfFile(file))) return nullptr;
  const std::string header =
      main ? std::filesystem::path(main_name.str()).filename().string()
           : preprocessor_.getHeaderSearchInfo().suggestPathToFileForDiagnostics(entry, main_name);
  if (header.rfind("glm/", 0) == 0) return nullptr;
  const bool ours = header.rfind("pelage/", 0) == 0;
  unit& u = *(place->second = std::make_unique<unit>());
  u.header = header;
  u.name = std::filesystem::path(header).replace_extension(wide ? "" : "glsl").string() + (wide ? "_64.glsl" : "");
  u.path = ours ? u.name.substr(7) : u.name;
  if (!ours || library_) return &u;
  u.include = "pelage/glsl/" + u.path;
  u.mirrored = true;
  const llvm::StringRef name = entry->tryGetRealPathName();
  if (const auto mirror = llvm::MemoryBuffer::getFile(name.drop_back(header.size()) + u.include)) {
    u.mirror_text = (*mirror)->getBuffer().str();
  }
  // A size's macro is the one whose value a shader may use only once.
  const llvm::Regex size("([A-Za-z0-9_]+)_has_one_value_in_a_shader");
  llvm::SmallVector<llvm::StringRef> found;
  for (llvm::StringRef rest = u.mirror_text; size.match(rest, &found); rest = rest.split(found[0]).second)
    u.sizes[found[1].str()];
  return &u;
}

bool headers::is_named(const Decl* d) {
  const FileID file = sources_.getFileID(sources_.getExpansionLoc(d->getLocation()));
  if (file == sources_.getMainFileID()) return true;
  if (named_.count(sources_.getFileEntryForID(file)) == 0) return false;
  const unit* u = unit_of(file);
  return u != nullptr && !u->mirrored;
}

void headers::note_doc(const NamespaceDecl* space) {
  if (!is_named(space)) return;
  unit* u = unit_of(sources_.getFileID(sources_.getExpansionLoc(space->getLocation())));
  const llvm::StringRef inside =
      llvm::StringRef(sources_.getCharacterData(space->getBeginLoc())).split('{').second.ltrim();
  llvm::StringRef rest = inside;
  while (rest.startswith("///"))
    rest = rest.split('\n').second;
  const llvm::StringRef first = rest.startswith("\n") ? inside.drop_back(rest.size()) : llvm::StringRef();
  for (const std::string& doc : {doc_of(space, false), first.str()}) {
    if (doc.empty()) continue;
    const auto known = llvm::find_if(u->docs, [&](const auto& one) { return one.second == doc; });
    if (known == u->docs.end()) {
      u->docs.emplace_back(qualified_name(space), doc);
    } else {
      known->first = qualified_name(space);  // at the beginning of one namespace, but above this one
    }
  }
}

std::vector<const unit*> headers::written() const {
  std::vector<const unit*> all;
  for (const auto& [key, u] : units_) {
    if (u && !u->mirrored && !u->entities.empty()) all.push_back(u.get());
  }
  return all;
}

std::set<std::string> headers::mirrored() const {
  std::set<std::string> all;
  for (const auto& [entry, u] : units_) {
    if (u && (u->mirrored || !u->entities.empty())) all.insert(u->header);
  }
  return all;
}

}  // namespace pelage::codegen
