// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "model.hpp"
#include "names.hpp"

#include <clang/Format/Format.h>
#include <clang/Tooling/Core/Replacement.h>

#include <algorithm>
#include <filesystem>
#include <functional>

namespace pelage::codegen {

namespace {

constexpr const char* licence = "// Copyright (c) 2026 The Pelage authors\n// SPDX-License-Identifier: MIT\n";

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

std::string memory_order_text() {
  return std::string(licence) + R"(// Generated by pelage-glsl: what std::memory_order is to the mirror.
#ifndef PELAGE_CORE_MEMORY_ORDER_GLSL
#define PELAGE_CORE_MEMORY_ORDER_GLSL

// The fence behind an acquire and before a release. A shader may define its own before it includes this file: Mesa's
// lavapipe, at least up to 22.3, loses invocations at a barrier in a loop when a workgroup is larger than a subgroup.
#ifndef PELAGE_FENCE
#define PELAGE_FENCE() memoryBarrierBuffer()
#endif

const int pelage_memory_order_relaxed = 0;
const int pelage_memory_order_consume = 1;
const int pelage_memory_order_acquire = 2;
const int pelage_memory_order_release = 3;
const int pelage_memory_order_acq_rel = 4;
const int pelage_memory_order_seq_cst = 5;

/// A value that was loaded: what comes after stays after it, if the order says so.
uint pelage_acquire(uint value, int order) {
  if (order != pelage_memory_order_relaxed && order != pelage_memory_order_release) {
    PELAGE_FENCE();
  }
  return value;
}

/// A value on its way to memory: what came before stays before it, if the order says so.
uint pelage_release(uint value, int order) {
  if (order >= pelage_memory_order_release) {
    PELAGE_FENCE();
  }
  return value;
}

#endif
)";
}

std::string memory_order_64_text() {
  return std::string(licence) + R"(// Generated by pelage-glsl: memory_order.glsl for cells of 64 bits.
#ifndef PELAGE_CORE_MEMORY_ORDER_64_GLSL
#define PELAGE_CORE_MEMORY_ORDER_64_GLSL

#include "memory_order.glsl"

// The load of a cell. A shader for hardware that loads 64 bits in two parts may define it before it includes this
// file, as atomicOr(cell, 0ul).
#ifndef PELAGE_LOAD_64
#define PELAGE_LOAD_64(cell) cell
#endif

/// As pelage_acquire() of a uint.
uint64_t pelage_acquire(uint64_t value, int order) {
  pelage_acquire(0u, order);
  return value;
}

/// As pelage_release() of a uint.
uint64_t pelage_release(uint64_t value, int order) {
  pelage_release(0u, order);
  return value;
}

#endif
)";
}

std::string strings_header(const std::vector<std::pair<std::string, std::string>>& files) {
  std::map<std::string, std::string> texts(files.begin(), files.end());
  std::map<std::string, std::vector<std::string>> closure;
  const auto identifier = [](std::string path) {
    path.resize(path.size() - std::string(".glsl").size());
    std::replace(path.begin(), path.end(), '/', '_');
    return path;
  };
  std::string text =
      std::string(licence) +
      "// Generated by pelage-glsl: change the headers, not this.\n"
      "#pragma once\n#include <array>\n#include <cstddef>\n#include <string_view>\n\n"
      "/// The GLSL mirror as text, for programs that compile shaders while they run. Each string is one\n"
      "/// file with its includes in it: pelage::glsl::order::k_buffer is order/k_buffer.glsl. Strings can\n"
      "/// follow one another, since the guards of what they share are in them.\n"
      "namespace pelage::glsl {\n\nnamespace detail {\n\n";
  std::string views;
  std::set<std::string> joined;
  // What a file includes is joined before it.
  const std::function<void(const std::string&)> add = [&](const std::string& path) {
    if (!joined.insert(path).second) return;
    const std::string& content = texts.at(path);
    std::string own;
    for (std::size_t begin = 0; begin < content.size();) {
      const std::size_t end = content.find('\n', begin) + 1;
      const std::string line = content.substr(begin, end - begin);
      begin = end;
      if (line.rfind("#include \"", 0) != 0) {
        own += line;
        continue;
      }
      const std::string named = line.substr(10, line.rfind('"') - 10);
      const auto target = (std::filesystem::path(path).parent_path() / named).lexically_normal().string();
      add(target);
      closure[path].push_back("\n" + own);
      closure[path].push_back(target);
      own.clear();
    }
    closure[path].push_back("\n" + own);
    std::string parts;
    int piece = 0;
    for (const std::string& part : closure[path]) {
      if (part.front() != '\n') {
        parts += ", " + identifier(part);
        continue;
      }
      const std::string name = identifier(path) + "_" + std::to_string(piece++);
      text += "inline constexpr char " + name + "[] = R\"glsl(" + part.substr(1) + ")glsl\";\n";
      parts += ", " + name;
    }
    views += "inline constexpr auto " + identifier(path) + " = join<" + parts.substr(2) + ">();\n";
  };
  for (const auto& [path, content] : files)
    add(path);
  text += R"(
/// Its parts one after another, with a 0 at the end. Joined when the program is compiled.
template <const auto&... Parts>
constexpr auto join() {
  std::array<char, (sizeof(Parts) + ...) - sizeof...(Parts) + 1> all{};
  std::size_t end = 0;
  const auto append = [&](const auto& part) {
    for (std::size_t i = 0; i + 1 < sizeof(part); ++i) all[end++] = part[i];
  };
  (append(Parts), ...);
  return all;
}

)" + views +
          "\n}  // namespace detail\n";
  std::string folder;
  for (const auto& [path, content] : files) {
    const std::string in = std::filesystem::path(path).parent_path().string();
    const std::string name = std::filesystem::path(path).stem().string();
    if (in != folder)
      text += (folder.empty() ? "\n" : "}  // namespace " + folder + "\n\n") + ("namespace " + in) + " {\n";
    folder = in;
    const std::string array = "detail::" + identifier(path);
    text += "inline constexpr std::string_view " + name + "{" + array + ".data(), " + array + ".size() - 1};\n";
  }
  return text + "}  // namespace " + folder + "\n\n}  // namespace pelage::glsl\n";
}

}  // namespace pelage::codegen
