# What people and CI type. Every target first installs the Debian packages it needs that are missing.
JOBS := $(shell nproc)
# Some tests wait more than they compute.
TESTS := $(shell expr $(JOBS) + 1)
.DEFAULT_GOAL := help
.PHONY: help salad gallery figures .npm build test python test-python blender-addon test-blender test-programs test-rest golden-renew golden-mutants mutants semantic-faults verify verify-table reproduce lint format sanitize clang clang-bytes .bench benches table1 error-atlas variants road speed cuts lod textures picture bench settle unseen batch-bench batch-scale batch-stops stops malformed .fuzzers fuzz fuzz-short hashes page-errors gallery-page install package test-package clean

help: ## this list
	@sed -n 's/^\([a-z0-9-]*\):.*## /\1\t/p' Makefile | expand -t 16

salad: build ## out/salad.png, .glb and .pov
	@scripts/salad.sh build/pomona

gallery: build ## the pictures of README.md and templates/README.md; FRUIT="okra fig" makes theirs alone
	@scripts/setup.sh gallery
	@scripts/gallery.sh build/pomona docs/pictures $(FRUIT)
	@scripts/gallery.py write

figures: build $(if $(filter textures,$(PAGE)),.npm) ## our counterpart of each figure of the paper, docs/reference/figures.md; FIGURE=8 makes one; PAGE=knives (or style, textures, batch, scenes) those of that page
	@scripts/setup.sh gallery $(if $(filter textures style,$(PAGE)),programs)
	@scripts/figures.py make build/pomona $(or $(PAGE),figures) $(FIGURE)

build: ## the program, at build/pomona
	@scripts/setup.sh build
	@cmake --preset program >build.log 2>&1 || { cat build.log; exit 1; }; rm -f build.log
	@cmake --build build --target pomona -j $(JOBS)

test: ## all tests that need nothing but Debian's libraries
	@scripts/setup.sh build test bench
	cmake --preset test
	cmake --build build -j $(JOBS)
	ctest --test-dir build --output-on-failure -j $(TESTS)

python: ## the Python module, as a wheel in build/python; docs/guides/python.md
	@scripts/setup.sh build python
	@cmake --preset python >build.log 2>&1 || { cat build.log; exit 1; }; rm -f build.log
	@cmake --build build --target pomona wheel pages pomona_archive -j $(JOBS)

test-python: python ## the module's tests, on the wheel as it is installed; FULL=1 compares the bytes of every fruit, format and knife, too
	@scripts/setup.sh test-python
	ctest --test-dir build --output-on-failure -j $(TESTS)
	$(if $(FULL),cmake --build build --target python_bytes_full)

blender-addon: build ## the add-on for Blender as a .zip in build/blender; docs/guides/blender.md
	@blender/make_addon.py build/pomona build/blender

BLENDER_PREFIX := out/test_blender/installed
test-blender: blender-addon python ## the add-on tried by Blender, on what is installed: with the program and with the Python module, and in a window under Xvfb; three minutes
	@scripts/setup.sh programs
	@rm -rf $(BLENDER_PREFIX) && cmake --install build --prefix $(BLENDER_PREFIX) >/dev/null
	tests/blender/addon_test.py $(BLENDER_PREFIX)/bin/pomona build/blender out/test_blender --module $(BLENDER_PREFIX)/lib/python3*/*-packages --window

# Other programs, and what runs in node or in a browser.
# Not again while nothing else is asked for: it takes away what is there, and half a minute.
.npm:
	@scripts/setup.sh npm
	@[ node_modules/.package-lock.json -nt package-lock.json ] && [ node_modules/.package-lock.json -nt package.json ] || \
		npm ci --no-audit --no-fund --loglevel=error

test-programs: .npm ## tests that start real programs: the glTF validator, POV-Ray, Inkscape
	@scripts/setup.sh build test programs
	cmake --preset test-programs
	cmake --build build -j $(JOBS)
	ctest --test-dir build --output-on-failure -j $(TESTS) -L programs

# Scenes, besides files of batches and of data sets.
SCENES := $(filter-out $(addprefix scenes/,cut_fruit.toml small_batch.toml thousand_pieces.toml),$(wildcard scenes/*.toml))

test-rest: build .npm ## every scene settles, all templates by five knives come to rest in MuJoCo, welded fruits hold, dishes are open; half an hour
	@scripts/setup.sh build test programs
	@mkdir -p out/rest
	status=0; for scene in $(SCENES); do build/pomona scene $$scene --quiet -o out/rest/layout.json || status=1; done; \
	for test in rest welds; do node tests/programs/mujoco_$$test.mjs build/pomona out/rest || status=1; done; \
	for scene in market_crate chopping_board conveyor strewn_hill fruit_bowl charcuterie; do \
	  node tests/programs/mujoco_dishes.mjs build/pomona out/rest scenes/$$scene.toml || status=1; \
	  node tests/programs/mujoco_dishes.mjs build/pomona out/rest --seconds 0.1 scenes/$$scene.toml:107 scenes/$$scene.toml:131 || status=1; \
	  case $$scene in market_crate|chopping_board|fruit_bowl) \
	    python3 -B tests/programs/godot_dishes.py build/pomona out/rest scenes/$$scene.toml:107 scenes/$$scene.toml:131 || status=1;; \
	  esac; \
	done; exit $$status

golden-renew: build ## keeps what is drawn now as golden pictures: NAME="onion_half pile" (or all) REASON="why"
	@scripts/setup.sh test programs
	@scripts/golden.py renew $(NAME) --programs --reason "$(REASON)"

golden-mutants: ## seeds faults into the program and asks the golden pictures: docs/reports/golden_mutants.md; a quarter of an hour
	@scripts/setup.sh build test programs
	nice scripts/golden_mutants.py

mutants: ## changes the generator by itself, 460 faults, and asks the tests that come by them: docs/reports/mutants.md; an hour or two; COUNT=460 ONLY=generator/cut SECONDS=60
	@scripts/setup.sh build test
	nice -n 19 scripts/mutants.py make $(and $(COUNT),--count $(COUNT))
	nice -n 19 scripts/mutants.py map $(and $(COUNT),--count $(COUNT))
	nice -n 19 scripts/mutants.py show $(and $(COUNT),--count $(COUNT)) $(and $(ONLY),--only $(ONLY)) $(and $(SECONDS),--seconds $(SECONDS))
	scripts/mutants.py report $(and $(COUNT),--count $(COUNT))

# The faults go into a copy of what git has.
FAULTY := build/semantic_faults
semantic-faults: .npm ## seeds 45 faults of meaning (and a reviewer's) into a copy, one build, and asks the tests: docs/reports/semantic_faults.md; half an hour
	@scripts/setup.sh build test programs
	rm -rf $(FAULTY) && mkdir -p $(FAULTY) && git ls-files | tar -cf - -T - | tar -xf - -C $(FAULTY)
	scripts/semantic_faults.py seed $(FAULTY)
	cmake -S $(FAULTY) -B $(FAULTY)/build --preset program
	cmake --build $(FAULTY)/build --target pomona -j $(JOBS)
	nice scripts/semantic_faults.py show $(FAULTY)
	scripts/semantic_faults.py report

verify: build ## does this machine give what is published? a tenth of the cuts, half a minute; ALL=1 compares all
	build/pomona verify $(and $(ALL),--all)

verify-table: build ## makes the published hashes anew, templates/hashes.txt, after a step that is meant to change them; some minutes
	build/pomona verify --all -o templates/hashes.txt

reproduce: ## builds the program in a dozen ways that must not matter, and two that must; an hour; BUILD="gcc-O0 fused" makes some
	@scripts/setup.sh build clang
	@scripts/reproduce.sh $(BUILD)

lint: .npm ## formatting, the naming of our own headers, and the types of our scripts
	@scripts/setup.sh build test lint
	@$(MAKE) --no-print-directory --keep-going --output-sync -j $(JOBS) $(LINTERS)

# Each uses one core.
LINTERS := .lint-naming .lint-format .lint-blender .lint-pages .lint-strict
.PHONY: $(LINTERS)
.lint-naming:
	scripts/check_naming.sh
.lint-format:
	scripts/format.sh --check
.lint-blender:
	mypy --config-file blender/mypy.ini blender
.lint-pages:
	npx tsc --project tsconfig.json
.lint-strict:
	npx tsc --project tsconfig.strict.json

format: ## formats the sources
	@scripts/setup.sh lint
	scripts/format.sh

sanitize: ## the tests again, under AddressSanitizer and UndefinedBehaviorSanitizer
	@scripts/setup.sh build test
	cmake --preset sanitize
	cmake --build build-sanitize -j $(JOBS)
	ctest --preset sanitize -j $(JOBS)

# The tests that ask for the same bits, the goldens, and hashes of one fruit's files against those of the other compiler.
clang: clang-bytes ## all of it compiled by clang, each source by itself, and the tests that compare bytes
	cmake --preset clang
	cmake --build build-clang -j $(JOBS)
	ctest --test-dir build-clang --output-on-failure -j $(TESTS) -R 'golden|[Bb]its|[Bb]yte|Thread|Random|Reproducible|Agreement'

clang-bytes: build ## the program compiled by clang: does it write what gcc's writes, and both what is published?
	@scripts/setup.sh build test clang
	cmake --preset clang-bytes
	cmake --build build-clang-bytes --target pomona -j $(JOBS)
	@mkdir -p out && rm -f out/gcc.tsv out/clang.tsv
	scripts/hashes.py make build/pomona out/gcc.tsv --only "tomato 7"
	scripts/hashes.py make build-clang-bytes/pomona out/clang.tsv --only "tomato 7"
	scripts/hashes.py compare out/gcc.tsv out/clang.tsv
	build/pomona verify
	build-clang-bytes/pomona verify

# One build for all measurements; each has its own target.
.bench:
	@scripts/setup.sh build test bench
	cmake --preset bench

benches: .bench ## compiles everything that measures, into build/bench, and runs none of it
	cmake --build build -j $(JOBS)

table1: .bench ## Table 1 of the paper, on this machine: out/table1.md and .json
	cmake --build build --target table1 -j $(JOBS)
	@mkdir -p out
	build/bench/table1 --out out/table1.md --json out/table1.json

error-atlas: .bench ## where the diffusers differ from the truth: out/atlas; stop it and it goes on later
	cmake --build build --target error_atlas -j $(JOBS)
	build/bench/error_atlas --out out/atlas --json out/atlas/atlas.json

variants: .bench ## a thousand variants of every template: out/variants.md and .json; stop it and it goes on later
	cmake --build build --target variants -j $(JOBS)
	@mkdir -p out
	build/bench/variants --out out/variants.md --json out/variants.json

unseen: build .bench ## 200 seeds of every template that nobody has chosen, halved and cut across: out/unseen.md, .json and a sheet of the worst, .png; FRUIT="lemon fig" SEEDS=101-140; stop it and it goes on later
	cmake --build build --target unseen -j $(JOBS)
	@mkdir -p out
	-build/bench/unseen $(FRUIT) --seeds $(or $(SEEDS),1-200) --out out/unseen.md --json out/unseen.json --worst out/unseen_worst.json
	@scripts/setup.sh gallery
	scripts/unseen_sheet.py build/pomona out/unseen_worst.json out/unseen.png

road: .bench ## a new variant of every template, halved, to the bytes of its .glb: time by stage, and memory, on one thread
	cmake --build build --target road -j $(JOBS)
	build/bench/road

speed: .bench ## what docs/reports/speed.md aims at, beside what this machine takes: a line for each aim; ROW="levels road"
	cmake --build build --target pomona road -j $(JOBS)
	scripts/measure_speed.py build/pomona build/bench/road $(ROW)

cuts: .bench ## 112 000 random and degenerate cuts of all templates, planes, strokes and closed knives, and 20 000 of turned blocks along their faces: out/cuts.md and .json; stop it and it goes on later
	cmake --build build --target cuts -j $(JOBS)
	@mkdir -p out
	build/bench/cuts --out out/cuts.md --json out/cuts.json

lod: .bench ## levels of detail of half of every fruit: how far off they are, how long they take
	cmake --build build --target lod -j $(JOBS)
	build/bench/lod

textures: .bench ## textures of half of every fruit at 512 texels, and of a tomato's six wedges at 1024: time, and how far from every texel diffused by itself
	cmake --build build --target textures -j $(JOBS)
	build/bench/textures --texels 512 --truth
	build/bench/textures --texels 1024 --knife wedges:6 --truth tomato

picture: .bench ## how long a picture of the salad in 1920x1080 takes, and how much memory
	cmake --build build --target picture -j $(JOBS)
	build/bench/picture

settle: .bench ## 30 to 10 000 pieces settled in a bowl: time, memory, gaps and overlaps; some minutes
	cmake --build build --target settle_bench -j $(JOBS)
	build/bench/settle

bench: .bench ## everything that measures, built into build/bench; runs the kernels
	cmake --build build -j $(JOBS)
	build/bench/kernels

batch-bench: build ## how many items a batch makes in a second, on 1 and 2 threads, and how much memory: 10, 100 and 1000 of them
	@scripts/measure_batch.py build/pomona

batch-scale: build ## what a hundred thousand items cost beside the making: bytes, manifest, merge, status
	@scripts/many_items.py build/pomona out/many_items 100000

stops: ## a run that writes files stopped 500 times, by signals, kills and failing calls: nothing is ever half there
	@scripts/setup.sh build test bench
	cmake --preset test
	cmake --build build --target pomona failing_calls -j $(JOBS)
	tests/cli/stops_test.py build/pomona $$(find build -name libfailing_calls.so) 500

malformed: build ## our own files spoilt in some 3000 ways, each told with its place within 2 s and 512 MB
	tests/malformed/malformed.py build/pomona

# The readers alone, by clang, under both sanitizers; a few minutes without ccache.
.fuzzers:
	@scripts/setup.sh build fuzz
	@cmake --preset fuzz >build-fuzz.log 2>&1 || { cat build-fuzz.log; exit 1; }; rm -f build-fuzz.log
	cmake --build build-fuzz --target fuzzers -j $(JOBS)

fuzz-short: .fuzzers ## 100 000 inputs of libFuzzer for every reader of templates, drawings, scenes, meshes, pictures, the same in each run: what CI does
	tests/fuzz/fuzz_test.py build-fuzz
	scripts/fuzz.py build-fuzz --runs $(or $(RUNS),100000) --again --jobs $(JOBS) $(READERS)

fuzz: .fuzzers ## RUNS=10000000 of libFuzzer for every reader, or READERS="ply glb"; hours; stop it and it goes on later
	scripts/fuzz.py build-fuzz --runs $(or $(RUNS),10000000) --jobs $(JOBS) $(READERS)

batch-stops: ## a batch killed 500 times, at random moments and at every k-th call; each time it goes on to the same bytes
	@scripts/setup.sh build test bench
	cmake --preset test
	cmake --build build --target pomona failing_calls -j $(JOBS)
	tests/cli/batch/stops_test.py build/pomona $$(find build -name libfailing_calls.so) 500

hashes: build ## SHA-256 of all that the program writes, out/hashes.tsv: to compare with scripts/hashes.py before and after a step
	@mkdir -p out
	scripts/hashes.py make build/pomona out/hashes.tsv

page-errors: ## how far the colours of pages are from the field's in C++, on three cuts of three seeds of every template, and how large pages are
	@scripts/setup.sh build test programs
	cmake --preset test-programs
	cmake --build build --target write_sections -j $(JOBS)
	build/tests/programs/write_sections out/sections 96 $(foreach name,$(basename $(notdir $(wildcard templates/*.toml))),$(name) $(name):1 $(name):2)
	node tests/programs/look_up.mjs out/sections --table

gallery-page: build ## a gallery for the web: out/gallery/index.html, and a page for each fruit that cuts it
	@scripts/gallery_page.py build/pomona out/gallery

install: python ## program, templates, scenes, manual page, completions, library, Python module: PREFIX=/usr/local DESTDIR=
	@DESTDIR="$(DESTDIR)" cmake --install build --prefix "$(or $(PREFIX),/usr/local)" >build/install.log || { cat build/install.log; exit 1; }
	@echo "installed into $(DESTDIR)$(or $(PREFIX),/usr/local)"

package: python ## the program and the Python module as build/package/pomona_*.deb
	@scripts/setup.sh package
	@cd build && cpack -B $(CURDIR)/build/package

test-package: package ## installs the .deb in a bare Debian 12 in a folder, and runs the README's commands there; needs root
	@scripts/setup.sh build test package
	cmake --preset test-programs
	rm -rf --one-file-system build/tests/programs/clean_root # the Debian of the run before
	ctest --test-dir build --output-on-failure -L package

clean: ## removes what was built, keeps out/
	rm -rf build build-sanitize build-clang build-clang-bytes build-fuzz
