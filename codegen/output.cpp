// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "model.hpp"
#include "names.hpp"

#include <clang/Format/Format.h>
#include <clang/Tooling/Core/Replacement.h>

#include <filesystem>
#include <functional>
#include <regex>

namespace pelage::codegen {

namespace {

constexpr const char* divider =
    "\n// ---------------------------------------------------------------------------------------------------------\n";

/// Lays GLSL out as the headers are laid out.
std::string formatted(const std::string& code) {
  constexpr const char* layout =
      "{BasedOnStyle: Google, ColumnLimit: 120, PenaltyBreakComment: 100, SortIncludes: Never, "
      "AllowShortLoopsOnASingleLine: "
      "false, AllowShortFunctionsOnASingleLine: None, AllowShortIfStatementsOnASingleLine: Never}";
  const auto style = llvm::cantFail(clang::format::getStyle(layout, "mirror.cpp", "none"));
  const clang::tooling::Range all(0, static_cast<unsigned>(code.size()));
  return llvm::cantFail(clang::tooling::applyAllReplacements(code, clang::format::reformat(style, code, {all})));
}

/// The macro that tells that a file has been included.
std::string guard(std::string name) {
  for (char& c : name)
    c = llvm::isAlnum(c) ? llvm::toUpper(c) : '_';
  return name;
}

std::string include_line(const unit& from, const std::string& path) {
  const bool beside = path.rfind("pelage/glsl/", 0) != 0;  // else the library's, seen from a user's header
  const std::filesystem::path folder = std::filesystem::path(from.path).parent_path();
  return "#include \"" + (beside ? std::filesystem::path(path).lexically_relative(folder).string() : path) + "\"\n";
}

using bindings = std::map<std::string, std::string>;

/// Every file that a file includes, with the values of its sizes. Checks that no one else chose others.
std::vector<std::pair<const unit*, bindings>> includes_of(const unit& u, problems& found) {
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
  std::vector<std::pair<const unit*, bindings>> result;
  for (const auto& [header, other] : others) {
    bindings& chosen = result.emplace_back(other, bindings()).second;
    for (const auto& [macro, value, where] : all) {
      if (other->sizes.count(macro) == 0) continue;
      const std::string& known = chosen.try_emplace(macro, value).first->second;
      if (known != value) found.add(where, "two sizes of one template, " + macro + " = " + known + " and " + value);
    }
  }
  return result;
}

/// All that a file includes, each after the sizes that it has here.
std::string includes_text(const unit& u, const std::vector<std::pair<const unit*, bindings>>& includes) {
  std::string text;
  for (const std::string& path : u.memory_orders)
    text += include_line(u, path);
  for (const auto& [other, chosen] : includes) {
    for (const auto& [macro, value] : chosen) {
      text += filled(
          "#ifndef {0}\n#define {0} {1}\n#elif {0} != {2}\n#error {3}: {0} is in use with another value, define "
          "PELAGE_PREFIX for a second one\n#endif\n",
          macro, value, preprocessed(value), u.path);
    }
    text += include_line(u, other->include.empty() ? other->path : other->include);
  }
  return text.empty() ? text : "\n" + text;
}

/// The sizes that a shader may choose: a default for each, or an #error where a choice cannot be. Defaults can.
std::string sizes_text(const unit& u) {
  std::string text;
  for (const auto& [macro, value] : u.sizes) {
    text += filled("\n#ifndef {0}\n#define {0} {1}\n", macro, value);
    for (const condition& c : u.conditions) {
      if (c.sizes == std::set<std::string>{macro}) text += filled("#elif !({0})\n#error {1}\n", c.text, c.message);
    }
    text += "#endif\n";
  }
  std::string several;
  for (const condition& c : u.conditions) {
    if (c.sizes.size() == 1) continue;
    several += filled("#{0} !({1})\n#error {2}\n", several.empty() ? "if" : "elif", c.text, c.message);
  }
  return several.empty() ? text : text + several + "#endif\n";
}

std::string prefixed_name(const std::string& name) {
  return "#define " + name + " PELAGE_PASTE(PELAGE_PREFIX, " + name.substr(name.find('_')) + ")\n";
}

/// With PELAGE_PREFIX the names of all that depends on a size are others for the length of the file.
struct sized_names {
  std::set<std::string> own;
  std::set<std::string> borrowed;  ///< of files included, which have their own names back at their ends
};

sized_names sized_names_of(const unit& u) {
  sized_names names;
  for (const entity* e : u.entities) {
    if (e->sized) names.own.insert(e->name);
    for (const auto& [needed, where] : e->needs) {
      if (needed->sized && needed->where != &u) names.borrowed.insert(needed->name);
    }
  }
  return names;
}

/// The guard of a file that can be included once for each size.
std::string prefix_text(const unit& u, const sized_names& names,
                        const std::vector<std::pair<const unit*, bindings>>& includes) {
  std::string text = filled(R"(
// For a second size in one shader define it anew and PELAGE_PREFIX, a word that takes the place of
// `{0}` in the names, and include this file again.
#ifdef PELAGE_PREFIX
)",
                            llvm::StringRef(u.entities.front()->name).split('_').first);
  for (const auto& [other, chosen] : includes) {
    for (const auto& [macro, value] : chosen)
      text += "#undef " + macro + "\n";
  }
  text +=
      "#define PELAGE_PASTE_(prefix, name) prefix##name\n"
      "#define PELAGE_PASTE(prefix, name) PELAGE_PASTE_(prefix, name)\n";
  for (const std::string& name : names.own)
    text += prefixed_name(name);
  if (!u.sizes.empty()) text += "#else\n";
  for (const auto& [macro, value] : u.sizes)
    text += filled("uint[{0}] {0}_has_one_value_in_a_shader();\n", macro);
  return text + filled("#endif\n#if defined(PELAGE_PREFIX) || !defined({0})\n", guard(u.name));
}

std::string borrowed_text(const sized_names& names) {
  std::string text;
  for (const std::string& name : names.borrowed)
    text += prefixed_name(name);
  return text.empty() ? text : "\n#ifdef PELAGE_PREFIX\n" + text + "#endif\n";
}

/// The end of what prefix_text() begins.
std::string prefix_end(const unit& u, const sized_names& names) {
  std::string text = "\n#ifdef PELAGE_PREFIX\n";
  std::set<std::string> all = names.own;
  all.insert(names.borrowed.begin(), names.borrowed.end());
  for (const std::string& name : all)
    text += "#undef " + name + "\n";
  return text + "#else\n#define " + guard(u.name) + "\n#endif\n";
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

constexpr const char* subgroup_text = R"(
#if !defined(GL_KHR_shader_subgroup_ballot) || !defined(GL_KHR_shader_subgroup_shuffle)
#error {0} needs subgroups: the extensions GL_KHR_shader_subgroup_ballot and GL_KHR_shader_subgroup_shuffle
#endif
#ifndef PELAGE_SUBGROUP_SIZE
#define PELAGE_SUBGROUP_SIZE gl_SubgroupSize
#endif

// [[unroll]] in a shader that requires GL_EXT_control_flow_attributes: drivers do not unroll loops over specialization
// constants, and an array in such a loop leaves the registers.
#ifndef PELAGE_UNROLL
#define PELAGE_UNROLL
#endif
)";

std::string cells_text(const unit& u, const glossary& words) {
  std::string text;
  std::string checks;
  for (const auto& [name, c] : u.cells) {
    const std::string doc = words.in_glsl(c.doc, c.scope, u.header);
    text += "//   " + c.call + (doc.empty() ? "" : "  " + doc.substr(doc.find('<') + 2)) + "\n";
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
std::string code_text(const unit& u, const std::string& once, const glossary& words) {
  const auto worded = [&](const entity* e, const std::string& text) {
    return words.in_glsl(text, e->qualified, u.header);
  };
  std::vector<const entity*> all = u.entities;
  llvm::sort(all, [](auto* a, auto* b) { return a->declared_at < b->declared_at; });
  pieces above(once);
  std::set<const entity*> declared;
  std::vector<const entity*> later;
  for (const entity* e : all) {
    declared.insert(e);
    if (!e->is_function()) {
      above.add(e, worded(e, e->doc + e->declaration));
    } else if (e->defined_at != e->declared_at.first) {
      above.add(e, worded(e, e->doc) + e->declaration + ";");
      later.push_back(e);
    } else {
      for (const auto& [needed, where] : e->needs) {
        if (needed->where == &u && needed->is_function() && declared.insert(needed).second) {
          above.add(needed, needed->declaration + ";");
        }
      }
      above.add(e, worded(e, e->doc + e->declaration + " " + e->body));
    }
  }
  llvm::sort(later, [](auto* a, auto* b) { return a->defined_at < b->defined_at; });
  pieces below(once);
  for (const entity* e : later)
    below.add(e, worded(e, e->declaration + " " + e->body));
  return above.text() + (later.empty() ? "" : divider) + below.text();
}

}  // namespace

std::string file_text(const unit& u, const glossary& words, problems& found) {
  const bool sized = llvm::any_of(u.entities, std::mem_fn(&entity::sized));
  const bool mixed = sized && !llvm::all_of(u.entities, std::mem_fn(&entity::sized));
  const std::string once = guard(u.name);
  const auto includes = includes_of(u, found);
  const sized_names names = sized_names_of(u);
  std::string text = std::string(licence) + "// Generated by pelage-glsl from " + u.header + ": change that one.\n";
  text += sized ? sizes_text(u) + prefix_text(u, names, includes) : filled("#ifndef {0}\n#define {0}\n", once);
  if (u.uses_int64) text += filled(int64_check, u.path);
  if (u.memory_orders.count(memory_order_64_path) != 0) text += filled(atomic_int64_check, u.path);
  if (u.uses_subgroup) text += filled(subgroup_text, u.path);
  text += includes_text(u, includes) + borrowed_text(names) + cells_text(u, words);
  for (const auto& [space, doc] : u.docs)
    text += "\n" + words.in_glsl(doc, space, u.header);
  text += code_text(u, mixed ? once + "_ONCE" : "", words) + (mixed ? "\n#define " + once + "_ONCE\n" : "");
  text = formatted(text + (sized ? prefix_end(u, names) : "") + "\n#endif\n");
  const bool over_a_group = llvm::any_of(includes, [](const auto& included) { return included.first->uses_subgroup; });
  return over_a_group ? std::regex_replace(text, std::regex("\n( +)for \\("), "\n$1PELAGE_UNROLL for (") : text;
}

}  // namespace pelage::codegen
