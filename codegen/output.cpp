// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "model.hpp"
#include "names.hpp"

#include <clang/Format/Format.h>
#include <clang/Tooling/Core/Replacement.h>

#include <algorithm>
#include <filesystem>

namespace pelage::codegen {

namespace {

constexpr const char* divider =
    "// ---------------------------------------------------------------------------------------------------------\n";

/// Lays GLSL out as the headers are laid out.
std::string formatted(const std::string& code) {
  clang::format::FormatStyle style = clang::format::getGoogleStyle(clang::format::FormatStyle::LK_Cpp);
  style.ColumnLimit = 120;
  style.ReflowComments = false;
  style.SortIncludes = clang::format::FormatStyle::SI_Never;
  style.AllowShortFunctionsOnASingleLine = clang::format::FormatStyle::SFS_None;
  style.AllowShortIfStatementsOnASingleLine = clang::format::FormatStyle::SIS_Never;
  style.AllowShortLoopsOnASingleLine = false;
  const clang::tooling::Range all(0, static_cast<unsigned>(code.size()));
  const auto changes = clang::format::reformat(style, code, {all});
  llvm::Expected<std::string> result = clang::tooling::applyAllReplacements(code, changes);
  if (!result) {
    llvm::consumeError(result.takeError());
    return code;
  }
  return *result;
}

std::string guard(const std::string& header) {
  std::string name = upper(std::filesystem::path(header).replace_extension("glsl").string());
  for (char& c : name) {
    if (isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

std::string extension_check(const std::string& path, const std::string& what, const std::vector<std::string>& any) {
  std::string condition;
  for (const std::string& e : any)
    condition += (condition.empty() ? "!defined(" : " && !defined(") + e + ")";
  return "#if " + condition + "\n#error " + path + " needs " + what + ": the extension " + any.front() + "\n#endif\n";
}

/// The files that a unit includes, and what each one's sizes are to be.
struct dependency {
  const unit* on;
  std::map<std::string, std::string> bindings;
};

std::vector<dependency> dependencies(const unit& u, problems& found) {
  std::map<std::string, dependency> by_path;
  for (const entity* e : u.entities) {
    for (const auto& [needed, where] : e->needs) {
      if (needed->where != nullptr && needed->where != &u) by_path[needed->where->header].on = needed->where;
    }
  }
  for (const entity* e : u.entities) {
    for (const auto& [macro, value] : e->bindings) {
      if (u.sizes.count(macro) != 0) {
        found.add(e->location, "a second size of one template, " + macro + " = " + value + ": a file holds one");
      }
      for (auto& [path, d] : by_path) {
        if (d.on->sizes.count(macro) == 0) continue;
        const auto [known, fresh] = d.bindings.try_emplace(macro, value);
        if (!fresh && known->second != value) {
          found.add(e->location, "two sizes of one template, " + macro + " = " + known->second + " and " + value);
        }
      }
    }
  }
  std::vector<dependency> all;
  for (const auto& [path, d] : by_path)
    all.push_back(d);
  return all;
}

std::string include_of(const unit& from, const unit& to) {
  if (!to.include.empty()) return to.include;
  return std::filesystem::path(to.path).lexically_relative(std::filesystem::path(from.path).parent_path()).string();
}

/// Defines the sizes of an included file, includes it, and checks that no one else chose others.
std::string include_text(const unit& u, const dependency& d) {
  std::string text;
  for (const auto& [macro, value] : d.bindings) {
    text += "#ifdef PELAGE_PREFIX\n#undef " + macro + "\n#endif\n";
    text += "#ifndef " + macro + "\n#define " + macro + " " + value + "\n#endif\n";
  }
  text += "#include \"" + include_of(u, *d.on) + "\"\n";
  for (const auto& [macro, value] : d.bindings) {
    std::string plain = value;
    plain.erase(std::remove(plain.begin(), plain.end(), 'u'), plain.end());
    text += "#if " + macro + " != " + plain + "\n#error " + u.path + ": " + macro +
            " is in use with another value, define PELAGE_PREFIX for a second one\n#endif\n";
  }
  return text;
}

/// With PELAGE_PREFIX the names of all that depends on a size are others for the length of the file.
std::string prefix_names(const unit& u, bool define) {
  std::set<std::string> names;
  for (const entity* e : u.entities) {
    if (e->sized) names.insert(e->name);
    for (const auto& [needed, where] : e->needs) {
      if (needed->sized) names.insert(needed->name);
    }
  }
  std::string text = "#ifdef PELAGE_PREFIX\n";
  if (define) {
    text +=
        "#define PELAGE_PASTE_(prefix, name) prefix##name\n"
        "#define PELAGE_PASTE(prefix, name) PELAGE_PASTE_(prefix, name)\n";
  }
  for (const std::string& name : names) {
    const std::size_t bare = name.find('_');
    text += define ? "#define " + name + " PELAGE_PASTE(PELAGE_PREFIX, " + name.substr(bare) + ")\n"
                   : "#undef " + name + "\n";
  }
  return text + "#endif\n";
}

std::string cells_text(const unit& u) {
  if (u.cells.empty()) return {};
  std::string text =
      "\n// The shader says where these cells lie before it includes this file; those that others write\n"
      "// meanwhile belong into a coherent buffer:\n";
  for (const auto& [name, c] : u.cells) {
    text += "//   " + c.call + (c.doc.empty() ? "" : "  " + c.doc.substr(c.doc.find('<') + 2)) + "\n";
  }
  for (const auto& [name, c] : u.cells) {
    text += "#ifndef " + name + "\n#error " + u.path + ": define " + c.call + " before the include\n#endif\n";
  }
  return text;
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
  std::sort(all.begin(), all.end(), [](auto* a, auto* b) { return a->declared_at < b->declared_at; });
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
  std::sort(later.begin(), later.end(), [](auto* a, auto* b) { return a->defined_at < b->defined_at; });
  pieces below(once);
  for (const entity* e : later)
    below.add(e, e->declaration + " " + e->body);
  return above.text() + (later.empty() ? "" : "\n" + std::string(divider)) + below.text();
}

}  // namespace

std::string file_text(const unit& u, problems& found) {
  const bool sized = std::any_of(u.entities.begin(), u.entities.end(), [](auto* e) { return e->sized; });
  const std::string once = guard(u.header);
  std::string text = std::string(licence) + "// Generated by pelage-glsl from " + u.header + ": change that one.\n";
  if (sized) {
    for (const auto& [macro, value] : u.sizes) {
      text += "\n#ifndef " + macro + "\n#define " + macro + " " + value + "\n#endif\n";
    }
    for (const auto& [condition, message] : u.conditions) {
      text += "#if !(" + condition + ")\n#error " + message + "\n#endif\n";
    }
    const std::string word = u.entities.front()->name.substr(0, u.entities.front()->name.find('_'));
    text +=
        "\n// For a second size in one shader define it anew and PELAGE_PREFIX, a word that takes the place of\n"
        "// `" +
        word + "` in the names, and include this file again.\n";
    for (const auto& [macro, value] : u.sizes) {
      text += "#ifndef PELAGE_PREFIX\nuint[" + macro + "] " + macro + "_has_one_value_in_a_shader();\n#endif\n";
    }
    text +=
        "#if defined(PELAGE_PREFIX) || !defined(" + once + ")\n#ifndef PELAGE_PREFIX\n#define " + once + "\n#endif\n";
  } else {
    text += "#ifndef " + once + "\n#define " + once + "\n";
  }
  std::string needs;
  if (u.uses_int64) {
    needs += extension_check(u.path, "64-bit integers",
                             {"GL_EXT_shader_explicit_arithmetic_types_int64", "GL_ARB_gpu_shader_int64"});
  }
  if (u.uses_atomic_int64) {
    needs += extension_check(u.path, "64-bit atomics", {"GL_EXT_shader_atomic_int64", "GL_NV_shader_atomic_int64"});
  }
  if (!needs.empty()) text += "\n" + needs;
  std::string includes;
  const auto include = [&](const char* path) {
    unit other;
    other.path = path;
    includes += "#include \"" + include_of(u, other) + "\"\n";
  };
  if (u.uses_atomics) include(memory_order_path);
  if (u.uses_atomic_int64) include(memory_order_64_path);
  for (const dependency& d : dependencies(u, found))
    includes += include_text(u, d);
  if (!includes.empty()) text += "\n" + includes;
  if (sized) text += "\n" + prefix_names(u, true);
  text += cells_text(u);
  if (!u.doc.empty()) text += "\n" + u.doc;
  const bool mixed = sized && !std::all_of(u.entities.begin(), u.entities.end(), [](auto* e) { return e->sized; });
  text += code_text(u, mixed ? once + "_ONCE" : "");
  if (mixed) text += "\n#define " + once + "_ONCE\n";
  if (sized) text += "\n" + prefix_names(u, false);
  return formatted(text + "\n#endif\n");
}

}  // namespace pelage::codegen
