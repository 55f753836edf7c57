#!/usr/bin/env bash
# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
# validate.sh INCLUDE_DIR: every file of the mirror compiles for Vulkan 1.2 and for OpenGL 4.5, passes spirv-val and
# is free of warnings; the whole of it stands in one shader, at several sizes too, and an error names what a shader
# forgot to define.
set -euo pipefail
include=$(cd "$1" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
# glslang 12 can follow `precise` without end where a loop's struct comes from a call over its own parts.
ulimit -v $((4 << 20))

mapfile -t files < <(cd "$include" && find pelage/glsl -name '*.glsl' | sort)
((${#files[@]})) || { echo "no mirror under $include" >&2; exit 1; }

# Cells by the type that their descriptions in the mirror give; what is no array of words is listed here.
cells=$(grep -rhoE '^#error .*: define PELAGE_[A-Z0-9_]+(\(i\))?' "$include/pelage/glsl" | grep -oE 'PELAGE_[A-Z0-9_]+(\(i\))?' |
  sort -u | while read -r cell; do
  case $cell in
    *NODES\(i\)) echo "#define $cell fragments[i]" ;;
    *_VERTICES\(i\)) echo "#define $cell vertices[i]" ;;
    *_ATOMIC_CELLS_64_*\(i\)) echo "#define $cell wide[i]" ;;
    *\(i\)) echo "#define $cell words[i]" ;;
    *_SIZE) echo "#define $cell 64" ;;
    *) echo "#define $cell one" ;;
  esac
done)

# shader FILE...: a shader that includes them, with everything that any of them asks a shader to define.
shader() {
  cat <<'END'
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
#ifdef VULKAN
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_atomic_int64 : require
#else
#extension GL_ARB_gpu_shader_int64 : require
#extension GL_NV_shader_atomic_int64 : enable
#endif
#include "pelage/glsl/core/fragment.glsl"
#include "pelage/glsl/visibility/deep_shadow_vertex.glsl"
layout(local_size_x = 8) in;
layout(std430, binding = 0) coherent buffer a { uint words[]; };
layout(std430, binding = 1) coherent buffer b { pelage_fragment fragments[]; };
layout(std430, binding = 2) coherent buffer c { uint64_t wide[]; };
layout(std430, binding = 3) coherent buffer d { uint one; uint other; };
layout(std430, binding = 4) coherent buffer e { pelage_deep_shadow_vertex vertices[]; };
END
  echo "$cells"
  printf '#include "%s"\n' "$@"
  echo 'void main() {}'
}

status=0
check() {
  local name=$1 source=$scratch/$2.comp
  if ! glslangValidator -I"$include" -V --target-env vulkan1.2 "$source" -o "$scratch/out.spv" >"$scratch/log" 2>&1 ||
    ! spirv-val --target-env vulkan1.2 "$scratch/out.spv" >>"$scratch/log" 2>&1 ||
    ! glslangValidator -I"$include" -l "$source" >>"$scratch/log" 2>&1 ||
    ! glslc -Werror -I "$include" --target-env=vulkan1.2 "$source" -o "$scratch/out.spv" >>"$scratch/log" 2>&1; then
    echo "$name is not valid:" >&2
    cat "$scratch/log" >&2
    status=1
  elif grep -i warning "$scratch/log" >&2; then
    echo "$name gives a warning" >&2
    status=1
  fi
}
for file in "${files[@]}"; do
  shader "$file" >"$scratch/one.comp"
  check "$file" one
done
shader "${files[@]}" >"$scratch/all.comp"
check "all of the mirror in one shader" all

# sizes HALVES [PREFIX]: all files with a size once more, at so many halves of their defaults. Each has a prefix of its
# own, for one may include another.
mapfile -t sized < <(cd "$include" && grep -rl _has_one_value_in_a_shader pelage/glsl | sort)
sizes() {
  (cd "$include" && sed -nE 's/^#define (PELAGE_\w+) ([0-9]+)$/\1 \2/p' "${sized[@]}") | while read -r macro value; do
    printf '#undef %s\n#define %s %d\n' "$macro" "$macro" $((value * $1 / 2))
  done
  local file
  for file in "${sized[@]}"; do
    [[ -z ${2-} ]] || printf '#undef PELAGE_PREFIX\n#define PELAGE_PREFIX %s_%s\n' "$2" "$(basename "$file" .glsl)"
    echo "#include \"$file\""
  done
  echo '#undef PELAGE_PREFIX'
}
((${#sized[@]})) || { echo "no sizes in the mirror under $include" >&2; exit 1; }
{ shader "${sized[@]}"; sizes 4 twice; sizes 1 half; sizes 2; } >"$scratch/sizes.comp"
check "three sizes of each kernel in one shader, and the first again" sizes

# said NAME TEXT: compiling what stdin holds fails, and the compiler says TEXT.
said() {
  cat >"$scratch/wrong.comp"
  if glslc -I "$include" --target-env=vulkan1.2 "$scratch/wrong.comp" -o "$scratch/out.spv" >"$scratch/log" 2>&1 ||
    ! tr -d ' ' <"$scratch/log" | grep -qF "${2// /}"; then  # glslang prints an #error word by word
    echo "$1: the compiler does not say: $2" >&2
    cat "$scratch/log" >&2
    status=1
  fi
}
head='#version 450
#extension GL_GOOGLE_include_directive : require'
said 'cells that are not defined' 'define PELAGE_ATOMIC_LIST_STORAGE_LINKS(i) before the include' <<END
$head
#include "pelage/glsl/order/a_buffer.glsl"
void main() {}
END
said 'a second size without a prefix' 'PELAGE_K_BUFFER_K_has_one_value_in_a_shader' <<END
$head
#define PELAGE_K_BUFFER_K 4
#include "pelage/glsl/order/k_buffer.glsl"
#undef PELAGE_K_BUFFER_K
#define PELAGE_K_BUFFER_K 8
#include "pelage/glsl/order/k_buffer.glsl"
void main() {}
END
said 'a size that another file has chosen' 'PELAGE_SORT_NETWORK_K is in use with another value' <<END
$head
#define PELAGE_SORT_NETWORK_K 4
#include "pelage/glsl/order/sorting_network.glsl"
#include "pelage/glsl/order/k_buffer.glsl"
void main() {}
END
said 'a size out of range' 'K must be in [1, 64]' <<END
$head
#define PELAGE_K_BUFFER_K 65
#include "pelage/glsl/order/k_buffer.glsl"
void main() {}
END
said 'sizes that do not fit each other' 'a slab must be whole words of 32 slices, or lie inside one' <<END
$head
#define PELAGE_OCCUPANCY_MAP_SLICES 96
#define PELAGE_OCCUPANCY_MAP_SLABS 2
#include "pelage/glsl/visibility/occupancy_map.glsl"
void main() {}
END
said 'a size out of range in a function' 'pelage::atomic_k_buffer: K must be in [1, 64]' <<END
$head
#define PELAGE_ATOMIC_K_BUFFER_K 0
#include "pelage/glsl/order/atomic_k_buffer.glsl"
void main() {}
END
said 'an optical depth that is an int' 'ambiguous best function' <<END
$head
#include "pelage/glsl/composite/optical_depth.glsl"
void main() { int optical = 0; float passed = pelage_transmittance_of(optical); }
END
((status)) || echo "${#files[@]} files of the mirror are valid GLSL, alone and together"
exit $status
