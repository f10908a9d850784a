#!/bin/bash
# Installs what the comparison needs, builds it and a release of Cleft, and measures: as root or with sudo. The
# arguments are those of benchmarks/performance.py.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/setup.sh

install_missing $build_packages $benchmark_packages

say "Building in build/benchmarks"
cmake --preset benchmarks >/dev/null
cmake --build --preset benchmarks -j "$(nproc)"
exec /usr/bin/python3 -B benchmarks/performance.py "$@"
