#!/bin/bash
# Builds truequad and proves it: everything under CTest in the release build, after what can be tested under
# AddressSanitizer and UndefinedBehaviorSanitizer: the geometry, the capture, the doors, and the library in programs on real
# drivers. Ends with a line that says whether all is well.
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

# build PRESET: quick when nothing changed; says the compiler's words only if they matter.
build() {
  local log=build/$1.log
  mkdir -p build
  { cmake --preset "$1" && cmake --build --preset "$1" -j "$jobs"; } >"$log" 2>&1 ||
    { tail -n 40 "$log" >&2; fail "the $1 build failed"; }
  echo "test.sh: built $1 ($((SECONDS - begin)) s)"
}

install_packages build samples tests programs || fail "packages are missing"

presets=(release)
[ -n "$quick" ] || presets=(sanitize release)
for preset in "${presets[@]}"; do
  build "$preset"
done
for preset in "${presets[@]}"; do
  ctest --test-dir "build/$preset" --output-on-failure -j "$jobs" || failed+=("$preset")
done

[ ${#failed[@]} = 0 ] || fail "FAILED: ${failed[*]} ($((SECONDS - begin)) s)"
echo "test.sh: all tests passed ($((SECONDS - begin)) s)"
