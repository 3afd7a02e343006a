# Sourced by ./run and ./test: installPackages GROUP… installs what cmake/packages.txt names and this machine lacks.

installPackages() {
    local list="$root/cmake/packages.txt" group wanted=() missing=() sudo=()
    for group in "$@"; do
        mapfile -t -O "${#wanted[@]}" wanted < <(awk -v group="$group" '$1 == group { print $2 }' "$list")
    done
    if ! command -v dpkg-query >/dev/null; then
        echo "This is not Debian: please see to these yourself (Debian's names): ${wanted[*]}" >&2
        return
    fi
    mapfile -t missing < <(printf '%s\n' "${wanted[@]}" | grep -vxFf <(
        dpkg-query -W -f='${db:Status-Status} ${Package}\n' "${wanted[@]}" 2>/dev/null | sed -n 's/^installed //p') || true)
    [ ${#missing[@]} -gt 0 ] || return 0

    echo "Installing Debian packages: ${missing[*]}" >&2
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || { echo "Neither root nor sudo: please have an administrator install them." >&2; exit 1; }
        sudo=(sudo)
    fi
    # Lists that are there but old name packages that the mirror no longer has: then once more with new ones.
    aptInstall() {
        "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}" >&2
    }
    local lacking
    lacking=$(apt-cache policy "${missing[@]}" 2>/dev/null | grep -c 'Candidate: [^(]' || true)
    if [ "$lacking" -lt ${#missing[@]} ] || ! aptInstall; then
        "${sudo[@]}" apt-get update >&2
        aptInstall
    fi
}

# Configures once and builds what changed; shows how far it is the first time, is silent when nothing changed, and never
# writes on stdout.
buildRelease() {
    if [ ! -f "$root/build/release/build.ninja" ]; then
        (cd "$root" && cmake --preset release) >&2
    fi
    if [ ! -x "$root/build/release/wold" ]; then
        ninja -C "$root/build/release" "$@" >&2
        return
    fi
    ninja -C "$root/build/release" --quiet "$@" | { grep -v '^ninja: no work to do' || true; } >&2
}
