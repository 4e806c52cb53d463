#!/bin/sh
# install_test.sh BUILD SOURCE: what `make install` leaves works by itself and knows nothing of the source tree.
set -u
build=$1 source=$2
box=$(mktemp -d) || exit 1
trap 'rm -rf "$box"' EXIT
failed=0
fail() { echo "$1"; failed=1; }

cmake --install "$build" --prefix "$box/first" >"$box/said" 2>&1 || { cat "$box/said"; exit 1; }
mv "$box/first" "$box/moved" # it may not know where it was put either
program=$box/moved/bin/carrel drills=$box/moved/share/carrel/drills

if grep -qF "$source" "$program"; then fail "the program names the source tree, $source"; fi
cd "$box" || exit 1
"$program" validate "$drills"/*.json >"$box/said" 2>&1 || { cat "$box/said"; fail "an installed drill is not valid"; }
"$program" run "$drills/square-knot.json" --json >"$box/result.json" 2>"$box/said" || { cat "$box/said"; fail "square-knot is not played"; }
grep -q '"passed": *true' "$box/result.json" || fail "square-knot is not passed"
[ -f "$drills/schema/drill.schema.json" ] || fail "the schema is not installed"
[ -f "$box/moved/share/doc/carrel/README.md" ] || fail "the documents are not installed"
"$program" bench speed >"$box/said" 2>&1 && fail "a benchmark that is not installed ran"
[ "$(wc -l <"$box/said")" = 1 ] && grep -q 'make build' "$box/said" || { cat "$box/said"; fail "bench: expected one line that says how to build it"; }
exit $failed
