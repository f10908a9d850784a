#!/bin/bash
# The installed command: does it run where it was moved to, are its manual pages in order, does completion know its
# words?
set -eu
prefix=$1
cleft=$prefix/bin/cleft

"$cleft" --version | grep -q '^cleft [0-9]'

for page in "" -mesh -info -check -convert -sizing -render -view; do
    manual=$prefix/share/man/man1/cleft$page.1
    warnings=$(man --warnings -E UTF-8 -l "$manual" 2>&1 >/dev/null || true)
    if [ -n "$warnings" ] || ! grep -q "^cleft${page/-/\\\\-} \\\\- [a-z]" "$manual"; then
        echo "$manual: $warnings"
        exit 1
    fi
done
grep -q -- '--feature' <(sed 's/\\-/-/g' "$prefix/share/man/man1/cleft-mesh.1")

. "$prefix/share/bash-completion/completions/cleft"
completes() { # completes WORD WORD... -- EXPECTED...: the last WORD is the one to complete
    COMP_WORDS=()
    while [ "$1" != -- ]; do
        COMP_WORDS+=("$1")
        shift
    done
    shift
    COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
    _cleft
    if [ "${COMPREPLY[*]}" != "$*" ]; then
        echo "${COMP_WORDS[*]} is completed as: ${COMPREPLY[*]}"
        exit 1
    fi
}
completes "$cleft" "" -- mesh info check convert sizing render view
completes "$cleft" me -- mesh
completes "$cleft" mesh a.nrrd --size-m -- --size-min --size-max
completes "$cleft" mesh --snap "" -- quality safe none
completes "$cleft" mesh --background l -- lattice
completes "$cleft" check --fi -- --fills-box
completes "$cleft" render --background "" -- light dark none
