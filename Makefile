# Everything a newcomer types. `make demo` and `make test` set up the machine themselves, on Debian.
JOBS := $(shell nproc)
DRILL := interrupted-stitch

.PHONY: demo test check build bench format hashes mutants clean packages
.DEFAULT_GOAL := build

build: packages
	@cmake --preset release > /dev/null
	@cmake --build build -j$(JOBS)

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

# Everything as it ships.
test: packages
	@cmake --preset release > /dev/null
	@cmake --build build -j$(JOBS)
	ctest --test-dir build -j$(JOBS) --output-on-failure

# The same with the address and undefined sanitizers, the simulation's own flags unchanged; what would take hours there
# is left out or plays less.
check: packages
	@cmake --preset sanitize > /dev/null
	@cmake --build build/sanitize -j$(JOBS)
	ctest --test-dir build/sanitize -j$(JOBS) --output-on-failure

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
