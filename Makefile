# SPDX-License-Identifier: MIT
#
#     make           lists these targets
#     make demo      makes pictures in build/demo
#     make test      the rules of the house, every unit test, every snippet against C++, the pages' programs: minutes
#     make test-all  that and everything else, browsers, emulators, other compilers: up to an hour
#     make unit T=filter/pcf/box   builds and runs one header's unit tests; without T all of them
#     make lint      the rules of the house that scripts hold
#     make format    formats all C++ files
#     make site      builds the site and serves it on port 8000; make site SERVE= only builds it, in build/site
#     make bench     ours against memcpy, GLM code, llvmpipe, Embree and OpenCV: a table, and plots in build/plots
#     make gpu       what this machine's GPU computes beside C++: a page for each API, build/gpu/report-*.md
#     make prove     every float and every code, on every implementation here: some hours on two cores
#     make release   what a release attaches, with SHA256SUMS: build/release
#     make clean     removes build
#
# Each installs the Debian packages that it lacks first: .ci/install. The work itself is CMake's: see CMakePresets.json.
# CONTRIBUTING.md lists what else there is, scripts and targets of CMake beside what they run.
.PHONY: help demo test test-all unit lint format site bench gpu prove release clean

help:
	@awk -F '  +' '/^#     make/ { printf "%-30s %s\n", $$2, $$3 }' Makefile

demo:
	@.ci/install build demo
	cmake --preset examples
	cmake --build --preset examples --target shadow_render
	build/examples/examples/shadow_render/shadow_render --output build/demo

test:
	@.ci/install test
	cmake --workflow --preset test
	@tests/summary test

test-all:
	@.ci/install test demo viewer gpu node engines browser site clang test-all newest-clang
	cmake --workflow --preset test-all
	@tests/summary test-all

unit:
	@.ci/install unit
	@test -f build/dev/build.ninja || cmake --preset dev
	cmake --build --preset dev --target $(if $(T),unit.$(subst /,.,$(T)),unit)
	$(if $(T),build/dev/tests/unit.$(subst /,.,$(T)),ctest --preset test -R '^unit/')

lint:
	@.ci/install unit format
	@test -f build/dev/build.ninja || cmake --preset dev
	cmake --build --preset dev --target lint.mirror
	ctest --preset test -R '^lint/'

format:
	@.ci/install format
	git ls-files -z '*.cpp' '*.hpp' ':!single_include/umbrage' | xargs -0 clang-format-14 -i

SERVE := 8000
site:
	@.ci/install unit node site
	@test -f build/dev/build.ninja || cmake --preset dev
	cmake --build --preset dev --target museum
	node examples/site/build.mjs build/site build/node_modules build/site-work build/dev/tests/proof/museum/museum
	$(if $(SERVE),build/node_modules/.bin/esbuild --servedir=build/site --serve=127.0.0.1:$(SERVE))

bench:
	@tests/bench/run

# A sample, in minutes; `make gpu SAMPLE=` runs every entry in every dialect over 2^20 inputs. A software driver can stand
# in for the GPU: make gpu BACKEND=lavapipe
BACKEND := hardware
SAMPLE := --count 16384 --other-count 4096 --other-every 4 --whole 16384
gpu:
	@.ci/install build gpu
	@tests/parity/gpu $(BACKEND) $(SAMPLE)

prove:
	@tests/proof/run

release:
	@.ci/install unit node
	cmake -D UMBRAGE=. -D CXX=g++ -D OUT=build/release -P tests/release/release.cmake

clean:
	rm -rf build
