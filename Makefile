# Everything a newcomer types. `make demo` and `make test` set up the machine themselves, on Debian.
JOBS := $(shell nproc)
DRILL := interrupted-stitch

PREFIX := /usr/local
# `make tidy` looks at sources that differ from this commit; a branch: make tidy SINCE=origin/main
SINCE := HEAD~

.PHONY: play demo test check lint tidy clang long build bench install package format hashes mutants clean packages
.DEFAULT_GOAL := build

build: packages
	@cmake --preset release > /dev/null
	@cmake --build build -j$(JOBS)

# Opens the window on the menu.
play: packages
	@cmake --preset release > /dev/null
	@cmake --build build -j$(JOBS) --target carrel
	build/carrel play

demo: packages
	@cmake --preset release > /dev/null
	@cmake --build build -j$(JOBS) --target carrel
	@mkdir -p out/demo
	build/carrel run scenarios/drills/$(DRILL).json --record out/demo/$(DRILL).carrel --out out/demo
	build/carrel replay --verify out/demo/$(DRILL).carrel
	@echo
	@echo "Report:    $(CURDIR)/out/demo/report.html"
	@echo "Figures:   $(CURDIR)/out/demo/result.json"
	@echo "Recording: $(CURDIR)/out/demo/$(DRILL).carrel"
	@ls out/demo/*.png 2> /dev/null | sed 's|^|Picture:   $(CURDIR)/|'

# Everything as it ships, but for what takes minutes alone.
test: packages
	@cmake --preset release > /dev/null
	@cmake --build build -j$(JOBS)
	ctest --test-dir build -j$(JOBS) --output-on-failure -LE check

# The rest of it; all tests with the address and undefined sanitizers, the simulation's own flags unchanged, what would
# take hours there left out; then the rules of the house.
check: packages
	@cmake --preset release > /dev/null
	@cmake --build build -j$(JOBS)
	ctest --test-dir build -j$(JOBS) --output-on-failure -L check
	@cmake --preset sanitize > /dev/null
	@cmake --build build/sanitize -j$(JOBS)
	ctest --test-dir build/sanitize -j$(JOBS) --output-on-failure
	@$(MAKE) --no-print-directory lint

# What the house asks of every line: format, names, lengths, pages. The quick commands that pages show are run.
lint: packages
	@tools/packages.sh clang-format
	@cmake --preset release > /dev/null
	@cmake --build build -j$(JOBS) --target carrel
	tools/lint
	tools/lint --commands

# clang-tidy on what differs from a commit.
tidy: packages
	@tools/packages.sh clang-tidy
	tools/lint --tidy --since $(SINCE)

# The second compiler, with the tests of sim.
clang: packages
	@tools/packages.sh clang
	@cmake --preset clang > /dev/null
	@cmake --build build/clang -j$(JOBS)
	ctest --test-dir build/clang -j$(JOBS) --output-on-failure -L '^sim_'

# What takes hours, before a change of the simulation is called done; docs/long.md has its table.
long: packages
	tests/long.sh

install: packages
	@cmake --preset release > /dev/null
	@cmake --build build -j$(JOBS) --target carrel
	cmake --install build --prefix $(PREFIX)

# A .deb for Debian 12, in build/.
package: packages
	@tools/packages.sh dpkg-dev file
	@cmake --preset release > /dev/null
	@cmake --build build -j$(JOBS) --target carrel
	cd build && cpack -G DEB

# A peer needs a package of its own; without it its figures are left out, with a word.
bench: packages
	@tools/packages.sh libode-dev || true
	@cmake --preset release > /dev/null
	@cmake --build build -j$(JOBS)
	build/carrel run scenarios/drills/$(DRILL).json --out out/bench
	@echo "Microseconds of processor time for a tick of 1 ms:"
	@grep -A 4 '"tick_us"' out/bench/result.json
	build/carrel bench speed --plot out/bench/speed.svg

# The table of state hashes anew, for a change that means to alter the simulation's bits.
hashes: build
	CARREL_RENEW_HASHES=1 CARREL_LONG_HASHES=1 ctest --test-dir build -j$(JOBS) -R 'Hashes' -V | sed -n 's/^.*hash:\([a-z]*\)/\1/p' | \
	  sort -t, -k1,1 -k2,2 -k3,3n > build/hashes.csv
	mv build/hashes.csv tests/hashes/hashes.csv

# Small faults, one at a time in a scratch copy: which does a test notice? An hour or two.
mutants: packages
	tests/mutants/run.py

format:
	@tools/packages.sh git clang-format
	git ls-files '*.cpp' '*.hpp' | xargs clang-format -i

clean:
	rm -rf build out

packages:
	@tools/packages.sh
