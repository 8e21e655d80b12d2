#!/usr/bin/env bash
# Unpacks Emscripten 3.1.69 from Debian 13 into .toolchain/ on a Debian 12 that has LLVM 19; installs nothing.
# Debian 13's Binaryen needs a newer libc than Debian 12's, so its tools are started through the unpacked loader.
# Usage: toolchain.sh TARGET_FOLDER
set -euo pipefail

target=$(realpath -m "$1")
work="$target.partial"
rm -rf "$work"
mkdir -p "$work/lists/partial" "$work/cache/archives/partial" "$work/debs" "$work/etc"

# The Debian mirror that this machine already uses; this script names no host.
mirror=$(apt-get indextargets --format '$(REPO_URI) $(CODENAME)' | awk '$2 ~ /^(bookworm|oldstable)$/ { print $1; exit }')
[ -n "$mirror" ] || { echo "No Debian mirror was found in this machine's apt sources." >&2; exit 1; }
echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror trixie main" > "$work/etc/trixie.list"

trixie=(
  -o "Dir::Etc::sourcelist=$work/etc/trixie.list" -o Dir::Etc::sourceparts=/dev/null
  -o "Dir::State::Lists=$work/lists" -o "Dir::Cache=$work/cache" -o APT::Get::List-Cleanup=0
  -o APT::Sandbox::User=root
)
apt-get "${trixie[@]}" -qq update
(cd "$work/debs" && apt-get "${trixie[@]}" -qq download emscripten binaryen libstdc++6 libgcc-s1 libc6)

mkdir -p "$work/root"
for package in "$work"/debs/*.deb; do dpkg -x "$package" "$work/root"; done
rm -rf "$work/debs" "$work/lists" "$work/cache" "$work/etc"

# Emscripten must not depend on its temporary name: everything below is relative to $target.
mv "$work/root" "$work.root" && rm -rf "$work" "$target" && mv "$work.root" "$target"

lib="$target/usr/lib/x86_64-linux-gnu"
loader=$(find "$target" -name 'ld-linux-x86-64.so.2' | head -n 1)
mkdir -p "$target/binaryen/bin"
for tool in "$target"/usr/bin/wasm*; do
  name=$(basename "$tool")
  printf '#!/bin/sh\nexec "%s" --library-path "%s" "%s" "$@"\n' "$loader" "$lib" "$tool" > "$target/binaryen/bin/$name"
  chmod +x "$target/binaryen/bin/$name"
done

emscripten="$target/usr/share/emscripten"
mkdir -p "$emscripten/node_modules"
# Debian's node-acorn would install Debian's own Node; the project has acorn from npm.
ln -sfn "$(realpath "$(dirname "$0")/../../node_modules/acorn")" "$emscripten/node_modules/acorn"
# Emscripten's scripts are CommonJS unless their name says otherwise, whatever the surrounding project is.
echo '{ "type": "commonjs" }' > "$target/package.json"
cat > "$emscripten/.emscripten" <<CONFIG
LLVM_ROOT = '/usr/lib/llvm-19/bin'
BINARYEN_ROOT = '$target/binaryen'
NODE_JS = '$(command -v node)'
CACHE = '$target/cache'
CONFIG

# Keep only the prebuilt system libraries that are linked; the others are built on demand.
found=$(find "$target/usr" -type d -name sysroot -path '*cache*' | head -n 1)
if [ -n "$found" ]; then
  rm -rf "$found"/lib/*/lto "$found"/lib/*/lto-pic "$found"/lib/*/pic "$found"/lib/*/libGL*
  mkdir -p "$target/cache"
  cp -a "$(dirname "$found")/." "$target/cache/"
  rm -rf "$(dirname "$found")"
fi
