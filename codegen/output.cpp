// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "model.hpp"
#include "names.hpp"

#include <clang/Format/Format.h>
#include <clang/Tooling/Core/Replacement.h>

#include <filesystem>
#include <functional>

namespace pelage::codegen {

namespace {

constexpr const char* divider =
    "\n// ---------------------------------------------------------------------------------------------------------\n";

/// Lays GLSL out as the headers are laid out.
std::string formatted(const std::string& code) {
  constexpr const char* layout =
      "{BasedOnStyle: Google, ColumnLimit: 120, ReflowComments: false, SortIncludes: Never, "
      "AllowShortLoopsOnASingleLine: "
      "false, AllowShortFunctionsOnASingleLine: None, AllowShortIfStatementsOnASingleLine: Never}";
  const auto style = llvm::cantFail(clang::format::getStyle(layout, "mirror.cpp", "none"));
  const clang::tooling::Range all(0, static_cast<unsigned>(code.size()));
  return llvm::cantFail(clang::tooling::applyAllReplacements(code, clang::format::reformat(style, code, {all})));
}

/// The macro that tells that a file has been included.
std::string guard(const std::string& name) {
  return llvm::StringRef(std::regex_replace(name, std::regex("\\.[^./]*$|[^A-Za-z0-9]"), "_")).upper() + "GLSL";
}

std::string include_line(const unit& from, const std::string& path) {
  const bool beside = path.rfind("pelage/glsl/", 0) != 0;  // else the library's, seen from a user's header
  const std::filesystem::path folder = std::filesystem::path(from.path).parent_path();
  return "#include \"" + (beside ? std::filesystem::path(path).lexically_relative(folder).string() : path) + "\"\n";
}

/// All that a file includes. Defines the sizes of each, and checks that no one else chose others.
std::string includes_text(const unit& u, problems& found) {
  std::map<std::string, const unit*> others;
  std::set<std::tuple<std::string, std::string, clang::SourceLocation>> all;  // macros, values, whose
  for (const entity* e : u.entities) {
    for (const auto& [needed, where] : e->needs) {
      if (needed->where != nullptr && needed->where != &u) others[needed->where->name] = needed->where;
    }
    for (const auto& [macro, value] : e->bindings) {
      all.emplace(macro, value, e->location);
      if (u.sizes.count(macro) == 0) continue;
      found.add(e->location, "a second size of one template, " + macro + " = " + value + ": a file holds one");
    }
  }
  std::string text;
  for (const std::string& path : u.memory_orders)
    text += include_line(u, path);
  for (const auto& [header, other] : others) {
    std::map<std::string, std::string> bindings;
    for (const auto& [macro, value, where] : all) {
      if (other->sizes.count(macro) == 0) continue;
      const std::string& known = bindings.try_emplace(macro, value).first->second;
      if (known != value) found.add(where, "two sizes of one template, " + macro + " = " + known + " and " + value);
    }
    for (const auto& [macro, value] : bindings) {
      text += filled("#ifdef PELAGE_PREFIX\n#undef {0}\n#endif\n#ifndef {0}\n#define {0} {1}\n#endif\n", macro, value);
    }
    text += include_line(u, other->include.empty() ? other->path : other->include);
    for (const auto& [macro, value] : bindings) {
      text += filled(
          "#if {0} != {1}\n#error {2}: {0} is in use with another value, define PELAGE_PREFIX for a second "
          "one\n#endif\n",
          macro, preprocessed(value), u.path);
    }
  }
  return text.empty() ? text : "\n" + text;
}

/// The sizes that a shader may choose, and the guard of a file that can be included once for each choice.
std::string sizes_text(const unit& u) {
  std::string text;
  for (const auto& [macro, value] : u.sizes)
    text += filled("\n#ifndef {0}\n#define {0} {1}\n#endif\n", macro, value);
  for (const auto& [condition, message] : u.conditions)
    text += filled("#if !({0})\n#error {1}\n#endif\n", condition, message);
  text += filled(R"(
// For a second size in one shader define it anew and PELAGE_PREFIX, a word that takes the place of
// `{0}` in the names, and include this file again.
)",
                 llvm::StringRef(u.entities.front()->name).split('_').first);
  for (const auto& [macro, value] : u.sizes)
    text += filled("#ifndef PELAGE_PREFIX\nuint[{0}] {0}_has_one_value_in_a_shader();\n#endif\n", macro);
  return text + filled("#if defined(PELAGE_PREFIX) || !defined({0})\n#ifndef PELAGE_PREFIX\n#define {0}\n#endif\n",
                       guard(u.name));
}

/// With PELAGE_PREFIX the names of all that depends on a size are others for the length of the file. The lines that
/// define them, and those that undefine them.
std::pair<std::string, std::string> prefix_names(const unit& u) {
  std::set<std::string> names;
  for (const entity* e : u.entities) {
    if (e->sized) names.insert(e->name);
    for (const auto& [needed, where] : e->needs) {
      if (needed->sized) names.insert(needed->name);
    }
  }
  std::string define =
      "\n#ifdef PELAGE_PREFIX\n#define PELAGE_PASTE_(prefix, name) prefix##name\n"
      "#define PELAGE_PASTE(prefix, name) PELAGE_PASTE_(prefix, name)\n";
  std::string undefine = "\n#ifdef PELAGE_PREFIX\n";
  for (const std::string& name : names) {
    define += "#define " + name + " PELAGE_PASTE(PELAGE_PREFIX, " + name.substr(name.find('_')) + ")\n";
    undefine += "#undef " + name + "\n";
  }
  return {define + "#endif\n", undefine + "#endif\n"};
}

constexpr const char* int64_check = R"(
#if !defined(GL_EXT_shader_explicit_arithmetic_types_int64) && !defined(GL_ARB_gpu_shader_int64)
#error {0} needs 64-bit integers: the extension GL_EXT_shader_explicit_arithmetic_types_int64
#endif
)";

constexpr const char* atomic_int64_check =
    R"(#if !defined(GL_EXT_shader_atomic_int64) && !defined(GL_NV_shader_atomic_int64)
#error {0} needs 64-bit atomics: the extension GL_EXT_shader_atomic_int64
#endif
)";

std::string cells_text(const unit& u) {
  std::string text;
  std::string checks;
  for (const auto& [name, c] : u.cells) {
    text += "//   " + c.call + (c.doc.empty() ? "" : "  " + c.doc.substr(c.doc.find('<') + 2)) + "\n";
    checks += filled("#ifndef {0}\n#error {1}: define {2} before the include\n#endif\n", name, u.path, c.call);
  }
  return u.cells.empty() ? text : R"(
// The shader says where these cells lie before it includes this file; those that others write
// meanwhile belong into a coherent buffer:
)" + text + checks;
}

/// Text in which what depends on no size stands between #ifndef and #endif: a second inclusion leaves it out.
class pieces {
 public:
  explicit pieces(const std::string& once) : once_(once) {}
  void add(const entity* e, const std::string& text) {
    const bool alone = !once_.empty() && !e->sized;
    if (alone != open_) text_ += alone ? "\n#ifndef " + once_ + "\n" : "\n#endif\n";
    open_ = alone;
    text_ += "\n" + text + "\n";
  }
  [[nodiscard]] std::string text() const { return open_ ? text_ + "\n#endif\n" : text_; }

 private:
  std::string once_;
  std::string text_;
  bool open_ = false;
};

/// Declarations and documentation in the header's order, then the bodies that the header has below. `once`: the macro
/// that is defined when the file has been included before, or nothing if it never is read twice.
std::string code_text(const unit& u, const std::string& once) {
  std::vector<const entity*> all = u.entities;
  llvm::sort(all, [](auto* a, auto* b) { return a->declared_at < b->declared_at; });
  pieces above(once);
  std::set<const entity*> declared;
  std::vector<const entity*> later;
  for (const entity* e : all) {
    declared.insert(e);
    if (!e->is_function()) {
      above.add(e, e->doc + e->declaration);
    } else if (e->defined_at != e->declared_at.first) {
      above.add(e, e->doc + e->declaration + ";");
      later.push_back(e);
    } else {
      for (const auto& [needed, where] : e->needs) {
        if (needed->where == &u && needed->is_function() && declared.insert(needed).second) {
          above.add(needed, needed->declaration + ";");
        }
      }
      above.add(e, e->doc + e->declaration + " " + e->body);
    }
  }
  llvm::sort(later, [](auto* a, auto* b) { return a->defined_at < b->defined_at; });
  pieces below(once);
  for (const entity* e : later)
    below.add(e, e->declaration + " " + e->body);
  return above.text() + (later.empty() ? "" : divider) + below.text();
}

}  // namespace

std::string file_text(const unit& u, problems& found) {
  const bool sized = llvm::any_of(u.entities, std::mem_fn(&entity::sized));
  const bool mixed = sized && !llvm::all_of(u.entities, std::mem_fn(&entity::sized));
  const std::string once = guard(u.name);
  const auto [define, undefine] = sized ? prefix_names(u) : std::pair<std::string, std::string>();
  std::string text = std::string(licence) + "// Generated by pelage-glsl from " + u.header + ": change that one.\n";
  text += sized ? sizes_text(u) : filled("#ifndef {0}\n#define {0}\n", once);
  if (u.uses_int64) text += filled(int64_check, u.path);
  if (u.memory_orders.count(memory_order_64_path) != 0) text += filled(atomic_int64_check, u.path);
  text += includes_text(u, found) + define + cells_text(u) + (u.doc.empty() ? "" : "\n") + u.doc;
  text += code_text(u, mixed ? once + "_ONCE" : "") + (mixed ? "\n#define " + once + "_ONCE\n" : "") + undefine;
  return formatted(text + "\n#endif\n");
}

}  // namespace pelage::codegen
