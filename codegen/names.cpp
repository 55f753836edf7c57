// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "names.hpp"

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclCXX.h>

#include <llvm/ADT/StringExtras.h>
#include <llvm/ADT/StringSwitch.h>
#include <llvm/Support/Regex.h>

#include <iterator>
#include <set>
#include <sstream>

namespace pelage::codegen {

namespace {

std::set<std::string> words(const char* text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

/// GLSL 4.60 §3.6, keywords and words reserved for later, as far as C++ lets one use them as a name.
bool is_reserved(const std::string& name) {
  static const std::set<std::string> all = words(R"(
    uniform buffer in out inout attribute varying shared centroid flat smooth noperspective patch sample invariant
    precise coherent restrict readonly writeonly subroutine layout discard highp mediump lowp precision demote uint
    atomic_uint common partition active resource superp asm input output half fixed filter sizeof cast interface
    external noinline row_major packed int64_t uint64_t float16_t float64_t main self)");
  static const llvm::Regex types(
      "^([biudhf]?vec[234]|d?mat[234](x[234])?|subpassInput|sampler(Shadow)?|"
      "(sampler|image|texture)([123]D|2DRect|2DMS|Cube|Buffer)(Array)?(Shadow)?)$");
  return all.count(name) != 0 || types.match(name);
}

/// GLSL 4.60 §8: a local of such a name would hide the function from the calls that the translation makes.
const std::set<std::string>& functions() {
  static const std::set<std::string> all = words(R"(
    radians degrees sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh pow exp log exp2 log2 sqrt
    inversesqrt abs sign floor trunc round roundEven ceil fract mod modf min max clamp mix step smoothstep isnan
    isinf floatBitsToInt floatBitsToUint intBitsToFloat uintBitsToFloat fma frexp ldexp packUnorm2x16
    packSnorm2x16 packUnorm4x8 packSnorm4x8 unpackUnorm2x16 unpackSnorm2x16 unpackUnorm4x8 unpackSnorm4x8
    packHalf2x16 unpackHalf2x16 packDouble2x32 unpackDouble2x32 length distance dot cross normalize ftransform
    faceforward reflect refract matrixCompMult outerProduct transpose determinant inverse lessThan lessThanEqual
    greaterThan greaterThanEqual equal notEqual any all not uaddCarry usubBorrow umulExtended imulExtended
    bitfieldExtract bitfieldInsert bitfieldReverse bitCount findLSB findMSB texture textureLod textureSize
    texelFetch textureGather atomicAdd atomicMin atomicMax atomicAnd atomicOr atomicXor atomicExchange
    atomicCompSwap atomicLoad atomicStore imageLoad imageStore imageSize dFdx dFdy fwidth noise1 noise2 noise3
    noise4 barrier memoryBarrier memoryBarrierBuffer memoryBarrierShared memoryBarrierImage groupMemoryBarrier
    subpassLoad anyInvocation allInvocations)");
  return all;
}

/// The names of what a declaration stands in and its own, with `between` between them, or `after_wide` behind what
/// is_wide().
std::string joined_names(const clang::NamedDecl* d, const char* between, const char* after_wide) {
  std::string name = d->getDeclName().isIdentifier() ? d->getName().str() : operator_name(d);
  for (const clang::DeclContext* c = d->getDeclContext(); c != nullptr; c = c->getParent()) {
    const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(c);
    const bool silent = space != nullptr && (space->isAnonymousNamespace() || space->isInline());
    if (const auto* named = llvm::dyn_cast<clang::NamedDecl>(c); named != nullptr && !silent) {
      name = named->getNameAsString() + (is_wide(c) ? after_wide : between) + name;
    }
  }
  return name;
}

}  // namespace

std::string preprocessed(const std::string& expression) {
  std::string text;
  for (const char c : expression) {
    if (c != 'u' || text.empty() || !llvm::isDigit(text.back())) text += c;
  }
  return text;
}

std::string operator_name(const clang::NamedDecl* d) {
  const auto* f = llvm::dyn_cast<clang::FunctionDecl>(d);
  if (f == nullptr || llvm::isa<clang::CXXMethodDecl>(f)) return {};
  const char* spelled = clang::getOperatorSpelling(f->getOverloadedOperator());
  return llvm::StringSwitch<std::string>(spelled == nullptr ? "" : std::to_string(f->getNumParams()) + spelled)
      .Case("2+", "add")
      .Case("1-", "negate")
      .Case("2-", "subtract")
      .Case("2*", "multiply")
      .Case("2/", "divide")
      .Default("");
}

std::string qualified_name(const clang::NamedDecl* d) {
  return joined_names(d, "::", "::");
}

std::string global_name(const clang::NamedDecl* d) {
  return joined_names(d, "_", "_64_");
}

std::string bad_name(const std::string& name, bool is_field) {
  if (name.find("__") != std::string::npos || name.rfind("gl_", 0) == 0) {
    return "the name `" + name + "` is reserved in GLSL";
  }
  if (is_reserved(name)) return "`" + name + "` is a keyword or a reserved word in GLSL";
  if (!is_field && is_builtin(name)) return "`" + name + "` is a built-in function in GLSL";
  return {};
}

std::string doc_of(const clang::Decl* d, bool beside) {
  const clang::ASTContext& context = d->getASTContext();
  const clang::RawComment* comment = context.getRawCommentForDeclNoCache(d);
  if (comment == nullptr || comment->isTrailingComment() != beside) return {};
  llvm::SmallVector<llvm::StringRef> lines;
  comment->getRawText(context.getSourceManager()).split(lines, '\n');
  for (llvm::StringRef& line : lines)
    line = line.trim();
  return llvm::join(lines, "\n") + (beside ? "" : "\n");
}

bool is_builtin(const std::string& name) {
  return functions().count(name) != 0;
}

bool is_in(const clang::NamedDecl* d, const std::string& space) {
  return d->getQualifiedNameAsString().rfind(space + "::", 0) == 0;
}

bool is_std_type(clang::QualType t, llvm::StringRef name) {
  const clang::CXXRecordDecl* r = t.getNonReferenceType()->getAsCXXRecordDecl();
  return r != nullptr && r->isInStdNamespace() && r->getName() == name;
}

}  // namespace pelage::codegen
