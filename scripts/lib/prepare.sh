# Shared by the scripts of this folder: install what is missing, build the release preset.
# Sourced, after `set -euo pipefail`, from the project's root.

# Lines of the list of packages $1 whose package is not installed.
missing_packages() {
  local package reason
  while read -r package reason; do
    case "$package" in '' | '#'*) continue ;; esac
    if [ "$(dpkg-query -W -f='${db:Status-Status}' "${package%\?}" 2>/dev/null)" != installed ]; then
      printf '%s\t%s\n' "$package" "$reason"
    fi
  done <"$1"
}

# Installs what is missing of the list of packages $1 (default: what Erg needs), and of those with a ? what this system
# has.
install_missing() {
  local list=${1:-scripts/packages.txt}
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "This is no Debian system, so nothing is installed; $list lists what is needed." >&2
    return 0
  fi
  local missing as_root=() package packages=()
  missing=$(missing_packages "$list")
  [ -n "$missing" ] || return 0
  if [ "$(id -u)" -ne 0 ] && command -v sudo >/dev/null; then as_root=(sudo); fi
  # Where only optional ones are missing they were not to be had before, mostly: no news are asked for.
  if cut -f1 <<<"$missing" | grep -qv '?$' && { [ "$(id -u)" -eq 0 ] || [ "${#as_root[@]}" -gt 0 ]; }; then
    "${as_root[@]}" apt-get update -qq
  fi
  for package in $(cut -f1 <<<"$missing"); do
    if [[ $package != *\? ]] || apt-cache show "${package%\?}" >/dev/null 2>&1; then packages+=("${package%\?}"); fi
  done
  [ "${#packages[@]}" -gt 0 ] || return 0
  if [ "$(id -u)" -ne 0 ] && [ "${#as_root[@]}" -eq 0 ]; then
    echo "Neither root nor sudo here. As root, run: apt-get install ${packages[*]}" >&2
    return 1
  fi
  echo "Installing what is missing, with apt-get:"
  awk -F'\t' '{ printf "  %-20s %s\n", $1, $2 }' <<<"$missing"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
    "${packages[@]}" >/dev/null
}

# Configures once, then builds what changed. CMake starts itself again when a CMakeLists.txt changes.
build_release() {
  if [ ! -f build/release/build.ninja ]; then
    echo "Configuring build/release"
    cmake --preset release >/dev/null
  fi
  cmake --build --preset release -- --quiet
}
