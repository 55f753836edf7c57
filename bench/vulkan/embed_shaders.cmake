# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT

# pelage_embed_shaders(target NAMESPACE pelage::test::kernels HEADER glsl/kernels.hpp FOLDER kernels [OPTIONS -O]
#   SHADERS core "k_buffer_8 k_buffer -DK=8" ...)
#
# Compiles FOLDER/core.comp, and FOLDER/k_buffer.comp with its own options, and adds them to the target as constants of
# type pelage::vulkan::kernel: NAMESPACE::core, NAMESPACE::k_buffer_8, and all of them in NAMESPACE::all. The target's
# sources include HEADER, which is written into the binary folder.
function(pelage_embed_shaders target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "NAMESPACE;HEADER;FOLDER" "OPTIONS;SHADERS")
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/embedded)
  set(declarations)
  set(arrays)
  set(definitions)
  set(entries)
  set(outputs)
  foreach(shader IN LISTS arg_SHADERS)
    separate_arguments(options UNIX_COMMAND "${shader}")
    list(POP_FRONT options name source)
    if(NOT source)
      set(source ${name})
    endif()
    set(input ${CMAKE_CURRENT_SOURCE_DIR}/${arg_FOLDER}/${source}.comp)
    set(output ${folder}/${name}.spv.inc)
    add_custom_command(OUTPUT ${output}
      COMMAND ${PELAGE_GLSLC} -Werror ${arg_OPTIONS} --target-env=vulkan1.2 -I ${PROJECT_SOURCE_DIR}/include ${options}
        -MD -MF ${output}.d -MT ${output} -mfmt=c -o ${output} ${input}
      DEPENDS ${input} DEPFILE ${output}.d)
    string(APPEND declarations "extern const pelage::vulkan::kernel ${name};\n")
    string(APPEND arrays "constexpr std::uint32_t ${name}_words[] =\n#include \"${name}.spv.inc\"\n;\n")
    string(APPEND definitions "constexpr pelage::vulkan::kernel ${name}{\"${name}\", ${name}_words};\n")
    string(APPEND entries "    ${name},\n")
    list(APPEND outputs ${output})
  endforeach()
  file(CONFIGURE OUTPUT ${folder}/${arg_HEADER} @ONLY CONTENT
"#pragma once
#include <span>

#include \"vulkan/kernel.hpp\"

namespace @arg_NAMESPACE@ {

@declarations@extern const std::span<const pelage::vulkan::kernel> all;

}  // namespace @arg_NAMESPACE@
")
  file(CONFIGURE OUTPUT ${folder}/kernels.cpp @ONLY CONTENT
"#include \"@arg_HEADER@\"

namespace @arg_NAMESPACE@ {
namespace {
@arrays@}  // namespace
@definitions@namespace {
constexpr pelage::vulkan::kernel table[] = {
@entries@};
}  // namespace
const std::span<const pelage::vulkan::kernel> all(table);
}  // namespace @arg_NAMESPACE@
")
  target_sources(${target} PRIVATE ${folder}/kernels.cpp ${outputs})
  target_include_directories(${target} PRIVATE ${folder})
  target_link_libraries(${target} PRIVATE pelage_vulkan)
endfunction()
