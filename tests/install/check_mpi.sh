#!/bin/sh
# Can programs be built with the installed component for MPI, by pkg-config and by CMake, and does the command run?
# check_mpi.sh PREFIX PKGCONFIG_FOLDER FOLDER MPICC MPIRUN
set -eu
prefix=$1
export PKG_CONFIG_PATH="$2"
folder=$3
mpicc=$4
mpirun=$5
source=$(dirname "$0")/mpi_consumer

rm -rf "$folder"
mkdir -p "$folder"
libraries=$(pkg-config --variable=libdir cleft-mpi)
"$mpicc" "$source/mpi_consumer.c" $(pkg-config --cflags --libs cleft-mpi) -Wl,-rpath,"$libraries" -o "$folder/program"
"$mpirun" -n 2 "$folder/program"

cmake -S "$source" -B "$folder/cmake" -DCMAKE_PREFIX_PATH="$prefix" >"$folder/log"
cmake --build "$folder/cmake" >>"$folder/log"
"$mpirun" -n 2 "$folder/cmake/mpi_consumer"

# A project without C.
mkdir "$folder/cxx"
cp "$source/mpi_consumer.c" "$folder/cxx/mpi_consumer.cpp"
sed 's/LANGUAGES C)/LANGUAGES CXX)/; s/mpi_consumer\.c)/mpi_consumer.cpp)/' \
    "$source/CMakeLists.txt" >"$folder/cxx/CMakeLists.txt"
cmake -S "$folder/cxx" -B "$folder/cxx/build" -DCMAKE_PREFIX_PATH="$prefix" >>"$folder/log"
cmake --build "$folder/cxx/build" >>"$folder/log"
"$mpirun" -n 2 "$folder/cxx/build/mpi_consumer"

[ ! -e "$prefix/bin/cleft-mpi" ] || {
    "$mpirun" -n 2 "$prefix/bin/cleft-mpi" --version | grep -q '^cleft-mpi [0-9]'
    man --warnings -l "$prefix/share/man/man1/cleft-mpi-mesh.1" >"$folder/man" 2>"$folder/warnings"
    [ ! -s "$folder/warnings" ]
}
