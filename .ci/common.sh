# What ./run, ./test and .ci/run share. To be sourced; speaks on stderr only.
# shellcheck shell=bash

set -euo pipefail

bolster_root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '%s\n' "$*" >&2; }

die() {
    say "$*"
    exit 1
}

# listedPackages GROUP...: the packages of these groups of packages.txt, one a line.
listedPackages() {
    awk -v wanted=" $* " '
        /^[[:space:]]*(#|$)/ { next }
        /^\[/ { gsub(/[][]/, ""); inside = index(wanted, " " $0 " "); next }
        inside { print }' "$bolster_root/.ci/packages.txt"
}

# missingPackages GROUP...: those of them that are not installed.
missingPackages() {
    local installed
    installed=$(dpkg-query --show --showformat '${db:Status-Status} ${Package}\n' 2>/dev/null |
        sed -n 's/^installed //p')
    listedPackages "$@" | grep --invert-match --line-regexp --fixed-strings --file=<(printf '%s\n' "$installed") || true
}

asRoot() {
    if [ "$(id -u)" -eq 0 ]; then
        env DEBIAN_FRONTEND=noninteractive "$@"
    else
        sudo env DEBIAN_FRONTEND=noninteractive "$@"
    fi
}

aptInstall() {
    asRoot apt-get install --yes --quiet=2 --no-install-recommends --option Dpkg::Use-Pty=0 "$@" >&2
}

# installPackages GROUP...: installs what is missing, and says so; silent when nothing is.
installPackages() {
    local -a missing
    if ! command -v dpkg-query >/dev/null; then
        say "This is not a Debian system: see .ci/packages.txt for what Bolster needs."
        return
    fi
    mapfile -t missing < <(missingPackages "$@")
    [ ${#missing[@]} -gt 0 ] || return 0

    say "Installing ${#missing[@]} missing Debian packages: ${missing[*]}"
    if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
        die "Neither root nor sudo here. As root: apt-get install --no-install-recommends ${missing[*]}"
    fi
    if ! apt-get install --simulate --no-install-recommends "${missing[@]}" >/dev/null 2>&1; then
        asRoot apt-get update --quiet=2 >&2
    fi
    # Lists that are a few days old name files that are gone: fresh lists, once more.
    aptInstall "${missing[@]}" || { asRoot apt-get update --quiet=2 >&2 && aptInstall "${missing[@]}"; }
}

# Runs a command with its output in a log file, which is shown only if the command fails.
quietly() {
    local log=$1 status=0
    shift
    mkdir -p "$(dirname -- "$log")"
    "$@" >"$log" 2>&1 </dev/null || status=$?
    [ "$status" -eq 0 ] || cat "$log" >&2
    return "$status"
}

# configure PRESET [OPTION...]: unless that was done before with the same options.
# (Ninja configures again by itself when a CMakeLists.txt has changed.)
configure() {
    local preset=$1 folder=$bolster_root/build/$1 stamp
    shift
    stamp="$folder/.configured-with"
    if [ -f "$folder/build.ninja" ] && [ "$(cat "$stamp" 2>/dev/null)" = "$*" ]; then
        return
    fi
    say "Configuring build/$preset"
    (cd "$bolster_root" && quietly "$folder/configure.log" cmake --preset "$preset" "$@")
    printf '%s' "$*" >"$stamp"
}

# Warnings are errors with the compiler that CI uses; another one may warn of things that nobody saw yet.
warningsAsErrors() {
    if [ "$(g++ -dumpversion)" = 12 ]; then
        printf -- '-DBOLSTER_WERROR=ON'
    else
        printf -- '-DBOLSTER_WERROR=OFF'
    fi
}

# build PRESET TARGET...: with ninja's progress on a terminal; else into a log, and a word about it if it takes long.
build() {
    local preset=$1 folder=$bolster_root/build/$1 watcher status=0
    shift
    if [ -t 2 ]; then
        ninja -C "$folder" "$@" >&2
        return
    fi
    (sleep 2 >/dev/null 2>&1 && say "Building $* in build/$preset (log: build/$preset/build.log)") &
    watcher=$!
    quietly "$folder/build.log" ninja -C "$folder" "$@" || status=$?
    kill "$watcher" 2>/dev/null || true
    return "$status"
}
