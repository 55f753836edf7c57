# Copyright (c) 2026 The Pelage authors
# SPDX-License-Identifier: MIT
# The Debian packages that the programs of this repository are built and checked with. Sourced, not run.

# shellcheck shell=bash disable=SC2034
pelage_frame_packages=(g++ cmake ninja-build libglm-dev libcli11-dev libfmt-dev nlohmann-json3-dev libstb-dev
  libtbb-dev)
pelage_test_packages=("${pelage_frame_packages[@]}" doctest-dev librapidcheck-dev libboost-context-dev python3
  glslang-tools glslc spirv-tools libclang-14-dev llvm-14-dev libvulkan-dev mesa-vulkan-drivers
  vulkan-validationlayers)
pelage_truth_packages=("${pelage_frame_packages[@]}" libembree-dev)
pelage_clang_packages=("${pelage_test_packages[@]}" clang libclang-rt-14-dev)
pelage_style_packages=("${pelage_test_packages[@]}" clang-format clang-tidy)

# pelage_install PACKAGE...: installs those that are missing; says in one line what it cannot, and exits 2.
pelage_install() {
  local package missing=() as_root=()
  for package; do
    [[ $(dpkg-query -W -f '${Status}' "$package" 2>/dev/null) == *' ok installed' ]] || missing+=("$package")
  done
  ((${#missing[@]})) || return 0
  if ((EUID != 0)); then
    as_root=(sudo)
    [[ -t 0 ]] || as_root+=(-n)
  fi
  printf 'installing %s: ' "${missing[*]}" >&2
  "${as_root[@]}" apt-get -qq update >/dev/null 2>&1 || true
  if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq install --yes --no-install-recommends \
    -o DPkg::Lock::Timeout=120 "${missing[@]}" >/dev/null 2>&1 </dev/null; then
    echo "not possible here; as root, apt-get install them" >&2
    exit 2
  fi
  echo "done" >&2
}
