#!/bin/sh
# What takes hours, step by step; a step that fails does not stop the others. Prints a table for docs/long.md and leaves
# what each step said in out/long.
cd "$(dirname "$0")/.." || exit 1
mkdir -p out/long
table=out/long/table.md
failed=0
jobs=$(nproc)

# step NAME COMMAND...: runs the command and adds a row.
step() {
    name=$1 begun=$(date +%s)
    shift
    if "$@" > "out/long/$name.log" 2>&1; then result=passed; else result="**failed**" failed=1; fi
    echo "| $name | $result | $(( ($(date +%s) - begun + 59) / 60 )) |" | tee -a $table
}

# Every file compiled by itself, without precompiled headers.
each_file_alone() { cmake --preset debug && cmake --build build/debug -j"$jobs"; }
whole_drills() {
    for drill in scenarios/drills/*.json; do
        echo "$drill"
        build/carrel run "$drill" --json | grep -q '"passed": *true' || return 1
    done
}
kills() { build/tests/app_commands_test --gtest_filter='Killed*' --gtest_repeat=10 --gtest_fail_fast; }
# in_window SUITE VARIABLE=VALUE...
in_window() {
    suite=$1
    shift
    env "$@" xvfb-run -a -s "-screen 0 1280x720x24" python3 tests/app/window/window_test.py build/carrel \
        build/tests/window_by_hand . "$suite"
}
old_processor() {
    tools/packages.sh qemu-user && qemu-x86_64 -cpu max build/carrel --version || return 1
    qemu-x86_64 -cpu Nehalem build/carrel --version
    test $? = 1
}

cmake --preset release > /dev/null && cmake --build build -j"$jobs" || exit 1
{
    echo "Commit $(git rev-parse --short HEAD), $(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -1), $jobs cores."
    printf '\n| step | result | minutes |\n|---|---|---|\n'
} | tee $table
step hashes-to-60-s env CARREL_LONG_HASHES=1 ctest --test-dir build -j"$jobs" --output-on-failure -R Hashes
step whole-copies ctest --test-dir build -C long --output-on-failure -R copies_of_whole_drills
step each-file-alone each_file_alone
step old-processor old_processor
step guidance ctest --test-dir build -C long --output-on-failure -R guidance_of_shaken_hands
step kills kills
step hands env SEEDS=1-10 build/tests/app_tie_by_hand_test
step window-ties in_window Ties SEEDS=1-10 PACE=1
step window-kills in_window Plays KILLS=100
step window-torture in_window Torture SECONDS=600
step window-times build/carrel bench window
step clang-tidy tools/lint --tidy
step elastic-ties build/carrel bench elastic-ties
step ties build/carrel bench ties
step mutants tests/mutants/run.py
step whole-drills whole_drills
exit $failed
