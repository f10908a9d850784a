# Sourced by run-demo and run-tests: the one list of Debian packages, and how they get there.

build_packages="
    cmake ninja-build g++ pkg-config
    libeigen3-dev libboost-dev libtet1.5-dev
    libdeflate-dev zlib1g-dev libtiff-dev libpng-dev libjpeg-dev libgdcm-dev
    libcli11-dev nlohmann-json3-dev"

# For -DCLEFT_WITH_MPI=ON.
mpi_packages="
    libopenmpi-dev openmpi-bin libhdf5-openmpi-dev"

binding_packages="
    swig
    python3-dev python3-numpy python3-matplotlib
    openjdk-17-jdk-headless
    mono-devel"

test_packages="
    clang clang-format clang-tidy black findent libclang-rt-dev gcovr libcmocka-dev python3 mypy
    gmsh tetgen calculix-ccx openfoam getdp python3-dolfinx-real python3-gmsh
    petsc-dev python3-h5py libdeal.ii-dev
    gfortran make abigail-tools freefem++ man-db lintian locales
    python3-numpy python3-meshio python3-vtk9 python3-nibabel python3-pydicom
    python3-pil python3-skimage python3-tifffile python3-tqdm
    chromium
    mkdocs-material doxygen"

benchmark_packages="
    libcgal-dev libtbb-dev gmsh tetgen
    python3-numpy python3-matplotlib python3-nibabel
    mricron-data"

# Other sources of packages than Debian have npm in their package of Node.
command -v npm >/dev/null || test_packages="$test_packages nodejs npm"

say() { printf '\n== %s\n' "$*"; }
fail() { printf '%s: %s\n' "$(basename "$0")" "$*" >&2; exit 1; }

is_installed() { [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

# install_missing PACKAGE...: installs what is missing, as root or with sudo; asks nothing.
install_missing() {
    command -v dpkg-query >/dev/null ||
        fail "this script is for Debian and its children; elsewhere, install $*" \
            "and build with cmake --preset release"
    missing=
    for package in "$@"; do
        is_installed "$package" || missing="$missing $package"
    done
    [ -n "$missing" ] || return 0
    if [ "$(id -u)" = 0 ]; then
        as_root=
    elif command -v sudo >/dev/null; then
        as_root=sudo
    else
        fail "these packages are missing, and you are neither root nor have sudo." \
            "Have them installed by: apt-get install$missing"
    fi
    say "Installing$missing"
    apt_get update && apt_get install -y --no-install-recommends $missing || fail "apt-get could not install$missing"
}

# apt_get ARGUMENT...: runs apt-get, and waits for another process that holds one of its locks, ten minutes at most.
# DPkg::Lock::Timeout alone is not enough: apt-get obeys it for the lock of dpkg, not for those of its lists and
# archives.
apt_get() {
    apt_log=$(mktemp)
    apt_deadline=$(($(date +%s) + 600))
    apt_status=1
    while [ $apt_status -ne 0 ]; do
        if (set -o pipefail && $as_root env DEBIAN_FRONTEND=noninteractive LC_ALL=C \
            apt-get -q -o DPkg::Lock::Timeout=600 "$@" 2>&1 | tee "$apt_log"); then
            apt_status=0
        elif grep -q '^E: Could not get lock' "$apt_log" && [ "$(date +%s)" -lt $apt_deadline ]; then
            sleep 2
        else
            break
        fi
    done
    rm -f "$apt_log"
    return $apt_status
}

# Compiles through ccache where there is one.
if command -v ccache >/dev/null; then
    export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
fi
