#!/bin/sh
# Do solvers of others take a mesh in parts from the installed component? Each example solves on four ranks and compares
# with an exact solution. Ends with 77, after a sentence, if the solver is not here.
# check_solver.sh SOLVER EXAMPLES PREFIX PKGCONFIG_FOLDER FOLDER MPICC MPIRUN PYTHON
set -eu
solver=$1
source=$2/solvers/$solver
prefix=$3
export PKG_CONFIG_PATH="$4"
folder=$5
mpicc=$6
mpirun=$7
python=$8

skip() {
    echo "skipped: $solver is not here; Debian has it in $1"
    exit 77
}

rm -rf "$folder"
mkdir -p "$folder"
case $solver in
petsc)
    pkg-config --exists petsc || skip petsc-dev
    libraries=$(pkg-config --variable=libdir cleft-mpi)
    "$mpicc" -O2 -Wall -Werror "$source/poisson.c" $(pkg-config --cflags --libs cleft-mpi petsc) -lm \
        -Wl,-rpath,"$libraries" -o "$folder/poisson"
    "$mpirun" -n 4 "$folder/poisson"
    ;;
dolfinx)
    "$python" -c "import dolfinx, h5py" 2>"$folder/log" || skip "python3-dolfinx-real and python3-h5py"
    CLEFT_MPI="$prefix/bin/cleft-mpi" XDG_CACHE_HOME="$folder/cache" "$python" -B "$source/run.py" "$mpirun" -n 4
    ;;
dealii)
    CXXFLAGS=-Werror cmake -S "$source" -B "$folder/build" -DCMAKE_PREFIX_PATH="$prefix" >"$folder/log" 2>&1 || {
        ! grep -q 'provided by "deal.II"' "$folder/log" || skip libdeal.ii-dev
        cat "$folder/log"
        exit 1
    }
    cmake --build "$folder/build"
    "$mpirun" -n 4 "$folder/build/poisson"
    ;;
esac
