#!/bin/sh
# packages_test.sh PACKAGE_SCRIPT: the script in a made-up system, whose apt-get writes down what it was asked.
set -u
script=$1
box=$(mktemp -d) || exit 1
trap 'rm -rf "$box"' EXIT
failed=0

fake() { printf '#!/bin/sh\n%s\n' "$2" >"$box/bin/$1" && chmod +x "$box/bin/$1"; }

# A system with only the tools the script may use, where every package but those of $1 is installed.
new_system() {
    rm -rf "$box/bin" "$box/asked" "$box/updated" && mkdir "$box/bin" && : >"$box/asked"
    for tool in bash sh cat grep mktemp rm env; do ln -s "$(command -v $tool)" "$box/bin/$tool"; done
    fake dpkg-query 'shift 3; for p in "$@"; do case " '"$1"' " in *" $p "*) ;; *) echo "installed $p" ;; esac; done'
    fake apt-get "echo \"\$DEBIAN_FRONTEND \$*\" >>'$box/asked'"
    fake sudo "echo sudo >>'$box/asked'; [ \"\$1\" != -n ] || shift; exec \"\$@\""
    fake true ""
}

run() { said=$(PATH="$box/bin" bash "$script" "$@" 2>&1 </dev/null); code=$?; asked=$(cat "$box/asked"); }

expect() { # WHAT ACTUAL PATTERN
    case $2 in
        $3) ;;
        *) echo "$1: expected '$3', got '$2'"; failed=1 ;;
    esac
}

# Words or work when nothing is missing would greet a developer at every build.
new_system "" && run
expect "all there: exit" $code 0
expect "all there: says" "$said" ""
expect "all there: asks" "$asked" ""

# A dry run that installs would be a nasty surprise.
new_system "cmake libbullet-dev" && run --dry-run
expect "dry run: exit" $code 0
expect "dry run: says" "$said" "*cmake libbullet-dev"
expect "dry run: asks" "$asked" ""

# Only what is missing is installed, without questions, and lists that are good are not fetched again.
new_system "cmake g++" && run
expect "install: exit" $code 0
expect "install: says" "$said" "*g++ cmake"
expect "install: asks" "$asked" "*noninteractive install * g++ cmake"
case $asked in *update*) echo "install: updates without need"; failed=1 ;; esac

# A task that needs more than building says so by name.
new_system "clang-format" && run clang-format
expect "more: asks" "$asked" "*noninteractive install * clang-format"

# On a fresh machine the first install fails for want of lists.
new_system "g++"
fake apt-get "echo \"\$*\" >>'$box/asked'; case \"\$*\" in *update*) : >'$box/updated' ;; *) [ -e '$box/updated' ] ;; esac"
run
expect "fresh: exit" $code 0
expect "fresh: asks" "$asked" "*install * g++*update*install * g++"

# Without network: apt-get's own words, and which packages, instead of a build that fails later.
new_system "g++" && fake apt-get 'echo "E: no network" >&2; exit 100' && run
expect "offline: exit" $code 1
expect "offline: says" "$said" "*E: no network*could not install*g++*"

# Who cannot install is told what to ask for. Root never gets there.
if [ "$(id -u)" -ne 0 ]; then
    new_system "g++" && rm "$box/bin/sudo" && run
    expect "neither root nor sudo: exit" $code 1
    expect "neither root nor sudo: says" "$said" "*neither root nor sudo*apt-get install g++"
    expect "neither root nor sudo: asks" "$asked" ""
fi

exit $failed
