#!/bin/sh
# Do the Debian packages install, work and go away again? check_packages.sh BUILD FOLDER PROGRAM.c TETGEN (ON or OFF):
# makes them, installs them into a root of their own, builds and runs PROGRAM with what is there, and removes them.
set -eu
build=$1
folder=$2
program=$3
tetgen=$4
root=$folder/root

rm -rf "$folder"
mkdir -p "$root/var/lib/dpkg/updates" "$root/var/lib/dpkg/info" "$root/var/lib/dpkg/triggers"
touch "$root/var/lib/dpkg/status" "$root/var/lib/dpkg/available"

cpack --config "$build/CPackConfig.cmake" -G DEB -B "$folder/packages" >"$folder/cpack.log" 2>&1 || {
    cat "$folder/cpack.log"
    exit 1
}
packages=$(ls "$folder"/packages/*.deb)

# What Debian itself complains of, short of advice; in one package of each kind, for it takes its time.
if command -v lintian >/dev/null; then
    lintian --allow-root --fail-on error --display-level error \
        $(ls "$folder"/packages/*.deb | grep -E '/(libcleft0|libcleft-dev|cleft)_')
fi

field() { dpkg-deb -f "$folder"/packages/"$1"_*.deb "$2"; }
expect() { case "$2" in *"$1"*) ;; *) echo "\"$1\" is not in \"$2\""; exit 1 ;; esac; }
refuse() { case "$2" in *"$1"*) echo "\"$1\" is in \"$2\""; exit 1 ;; esac; }
expect libc6 "$(field libcleft0 Depends)"
refuse gdcm "$(field libcleft0 Depends)"
expect "libcleft0 (= " "$(field libcleft-dev Depends)"
expect "activate-noawait ldconfig" "$(dpkg-deb -I "$folder"/packages/libcleft0_*.deb triggers)"
expect "libcleft 0 libcleft0 (>= " "$(dpkg-deb -I "$folder"/packages/libcleft0_*.deb shlibs)"
for package in $packages; do
    text=$(dpkg-deb --fsys-tarfile "$package" | tar xO "./usr/share/doc/$(dpkg-deb -f "$package" Package)/copyright")
    expect "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/" "$text"
    expect "License: Expat" "$text"
    expect "libcleft: Eigen" "$text"
    case $tetgen in
        ON) expect "must offer them the source" "$text" ;;
        *) refuse AGPL "$text" ;;
    esac
    if [ -n "$(dpkg-deb -c "$package" | awk '$2 != "root/root"')" ]; then
        echo "$package has files that are not root's"
        exit 1
    fi
done

# Into a root of its own, which has no other packages: dependencies are looked at above.
manage() { dpkg --root="$root" --force-not-root --force-depends --force-unsafe-io \
    --force-script-chrootless --log=/dev/null "$@"; }
manage -i $packages >"$folder/install.log" 2>&1 || { cat "$folder/install.log"; exit 1; }
dpkg --root="$root" --audit

pc=$(find "$root" -name cleft.pc)
export PKG_CONFIG_PATH="${pc%/*}"
flags=$(pkg-config --cflags --libs cleft)
cc "$program" $flags -o "$folder/program"
libraries=$(pkg-config --variable=libdir cleft)
LD_LIBRARY_PATH="$libraries" "$folder/program"
if [ -x "$root/usr/bin/cleft" ]; then
    "$root/usr/bin/cleft" --version
    [ -e "$root/usr/share/man/man1/cleft.1.gz" ]
fi

names=$(for package in $packages; do dpkg-deb -f "$package" Package; done)
manage -P $names >"$folder/remove.log" 2>&1 || { cat "$folder/remove.log"; exit 1; }
left=$(find "$root" -path "$root/var" -prune -o -type f -print -o -type l -print)
if [ -n "$left" ]; then
    echo "left behind: $left"
    exit 1
fi
