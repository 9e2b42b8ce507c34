#!/usr/bin/env bash
# Unpacks the xsimd headers of a later Debian suite into a folder, from the mirror that apt already uses. Nothing is
# installed, and apt's configuration stays as it is.
#
# usage: newer_xsimd.sh SUITE FOLDER   the headers are then in FOLDER/usr/include
set -euo pipefail
suite=$1
folder=$2

fail() {
    echo "newer_xsimd.sh: no xsimd of $suite: $1" >&2
    exit 77
}

[[ -d $folder/usr/include/xsimd ]] && exit
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
mkdir -p "$folder"/apt/{lists,cache}
mirror=$(apt-get indextargets --format '$(CREATED_BY) $(COMPONENT) $(ORIGIN) $(RELEASE) $(REPO_URI)' |
    awk '$1 == "Packages" && $2 == "main" && $3 == "Debian" && $4 !~ /-/ {print $5; exit}')
[[ $mirror ]] || fail "apt has no Debian mirror"
keys=/usr/share/keyrings/debian-archive-keyring.gpg
echo "deb [signed-by=$keys] $mirror $suite main" >"$folder/apt/sources.list"

options=(-o "Dir::Etc::sourcelist=$folder/apt/sources.list" -o Dir::Etc::sourceparts=-
    -o "Dir::State::lists=$folder/apt/lists" -o "Dir::Cache=$folder/apt/cache" -o APT::Sandbox::User=root)
apt-get "${options[@]}" update >/dev/null || fail "apt-get update failed"
(cd "$folder/apt" && apt-get "${options[@]}" download libxsimd-dev >/dev/null) || fail "download failed"
dpkg-deb -x "$folder"/apt/libxsimd-dev_*.deb "$folder"
rm -r "$folder/apt"
