#!/bin/bash
# Builds truequad and proves it: everything under CTest in the release build, after the kernel's tests under
# AddressSanitizer and UndefinedBehaviorSanitizer. Ends with a line that says whether all is well.
#
#   ./test.sh            everything
#   ./test.sh --quick    without the sanitizers
set -euo pipefail
cd "$(dirname "$0")"
source tests/packages.sh

quick=
case ${1:-} in
  '') ;;
  --quick) quick=1 ;;
  *) echo "usage: $0 [--quick]" >&2; exit 2 ;;
esac
jobs=$(nproc)
begin=$SECONDS
failed=()

fail() { echo "test.sh: $*" >&2; exit 1; }

# build PRESET [TARGET]: quick when nothing changed; says the compiler's words only if they matter.
build() {
  local log=build/$1.log
  mkdir -p build
  { cmake --preset "$1" && cmake --build --preset "$1" -j "$jobs" ${2:+--target "$2"}; } >"$log" 2>&1 ||
    { tail -n 40 "$log" >&2; fail "the $1 build failed"; }
  echo "test.sh: built $1 ($((SECONDS - begin)) s)"
}

install_packages build samples tests programs || fail "packages are missing"

build release
if [ -z "$quick" ]; then
  # The kernel is where all arithmetic is; programs and drivers are not built with sanitizers, nor is a library that is
  # preloaded into them.
  build sanitize kernel_test
  ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1 build/sanitize/tests/kernel/kernel_test --gtest_brief=1 ||
    failed+=(sanitize)
fi
ctest --test-dir build/release --output-on-failure -j "$jobs" || failed+=(release)

[ ${#failed[@]} = 0 ] || fail "FAILED: ${failed[*]} ($((SECONDS - begin)) s)"
echo "test.sh: all tests passed ($((SECONDS - begin)) s)"
