# Shared by the scripts of this folder: install what is missing, build the release preset.
# Sourced, after `set -euo pipefail`, from the project's root.

# Lines of scripts/packages.txt whose package is not installed.
missing_packages() {
  local package reason
  while read -r package reason; do
    case "$package" in '' | '#'*) continue ;; esac
    if [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
      printf '%s\t%s\n' "$package" "$reason"
    fi
  done <scripts/packages.txt
}

install_missing() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "This is no Debian system, so nothing is installed; scripts/packages.txt lists what Erg needs." >&2
    return 0
  fi
  local missing as_root=()
  missing=$(missing_packages)
  [ -n "$missing" ] || return 0
  echo "Installing what is missing, with apt-get:"
  awk -F'\t' '{ printf "  %-20s %s\n", $1, $2 }' <<<"$missing"
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "Neither root nor sudo here. As root, run: apt-get install" $(cut -f1 <<<"$missing") >&2
      return 1
    fi
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -qq
  # shellcheck disable=SC2046 # one word for each package
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
    $(cut -f1 <<<"$missing") >/dev/null
}

# Configures once, then builds what changed. CMake starts itself again when a CMakeLists.txt changes.
build_release() {
  if [ ! -f build/release/build.ninja ]; then
    echo "Configuring build/release"
    cmake --preset release >/dev/null
  fi
  cmake --build --preset release -- --quiet
}
