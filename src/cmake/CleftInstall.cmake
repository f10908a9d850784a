# The install tree: what goes where, and in which package (component) it is given out:
#
#   runtime, development         libcleft;      its headers, static library, CMake package and cleft.pc
#   io, io_development           libcleft_io;   its header, static library and cleft-io.pc
#   mpi, mpi_development         libcleft_mpi;  its header and cleft-mpi.pc
#   mpi_command                  the cleft-mpi command and its manual pages
#   command                      the cleft command, its manual pages and shell completion
#   fortran                      the Fortran modules
#
# Every path is relative to the prefix, and so is what the files say of each other: the tree can be moved. Within
# another project, which has an install tree of its own, nothing is installed unless CLEFT_INSTALL asks for it.
include(CMakePackageConfigHelpers)
include(CleftPkgConfig)

set(CLEFT_INSTALL_CMAKEDIR ${CMAKE_INSTALL_LIBDIR}/cmake/Cleft)

# Modules of Fortran can be read by the compiler that wrote them alone, so that their folder is named after it.
if(CLEFT_BUILD_FORTRAN)
    string(TOLOWER ${CMAKE_Fortran_COMPILER_ID} compiler)
    string(REPLACE gnu gfortran compiler ${compiler})
    string(REGEX REPLACE "\\..*" "" compiler_version ${CMAKE_Fortran_COMPILER_VERSION})
    set(CLEFT_INSTALL_MODULEDIR ${CMAKE_INSTALL_INCLUDEDIR}/cleft/${compiler}-${compiler_version}
        CACHE STRING "Where Fortran's modules are installed")
endif()

# cleft_install_library(TARGET NAME COMPONENT DEVELOPMENT_COMPONENT): installs a library and Cleft-NAME.cmake, which
# describes it to CMake.
function(cleft_install_library target name component development)
    install(TARGETS ${target} EXPORT Cleft-${name}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component} NAMELINK_COMPONENT ${development}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${development}
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${component})
    install(EXPORT Cleft-${name} NAMESPACE Cleft:: DESTINATION ${CLEFT_INSTALL_CMAKEDIR} COMPONENT ${development})
endfunction()

# cleft_install_headers(COMPONENT HEADER...)
function(cleft_install_headers component)
    list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/include/cleft/)
    install(FILES ${ARGN} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/cleft COMPONENT ${component})
endfunction()

# cleft_find_libraries_from(TARGET FOLDER): makes a program or library look for ours relative to where it lies.
function(cleft_find_libraries_from target folder)
    if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}" OR IS_ABSOLUTE "${folder}")
        set(rpath ${CMAKE_INSTALL_FULL_LIBDIR})
    else()
        file(RELATIVE_PATH rpath /prefix/${folder} /prefix/${CMAKE_INSTALL_LIBDIR})
        string(REGEX REPLACE "/$" "" rpath "\$ORIGIN/${rpath}")
    endif()
    set_target_properties(${target} PROPERTIES INSTALL_RPATH "${rpath}")
endfunction()

function(cleft_install_core)
    if(NOT CLEFT_INSTALL)
        return()
    endif()
    cleft_install_library(cleft_shared shared runtime development)
    cleft_install_library(cleft_static static development development)
    cleft_install_headers(development cleft.h cleft_status.h cleft_parts.h cleft.hpp cleft_context.hpp)
    install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_BINARY_DIR}/install/NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR}
        COMPONENT runtime)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development
        FILES_MATCHING PATTERN *.md PATTERN decisions EXCLUDE PATTERN images EXCLUDE)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development
        PATTERN build EXCLUDE PATTERN __pycache__ EXCLUDE)

    set(tetgen_flags)
    if(CLEFT_WITH_TETGEN)
        cleft_link_flags(tetgen_flags ${TETGEN_LIBRARY})
    endif()
    cleft_cxx_runtime(runtime_names)
    list(TRANSFORM runtime_names PREPEND -l OUTPUT_VARIABLE runtime_flags)
    list(JOIN runtime_flags " " runtime_flags)
    string(STRIP "${tetgen_flags} ${runtime_flags} ${CMAKE_THREAD_LIBS_INIT}" cleft_private_libs)
    cleft_install_pkgconfig(cleft development)

    set(made ${PROJECT_BINARY_DIR}/install)
    configure_package_config_file(${PROJECT_SOURCE_DIR}/src/cmake/CleftConfig.cmake.in ${made}/CleftConfig.cmake
        INSTALL_DESTINATION ${CLEFT_INSTALL_CMAKEDIR} NO_SET_AND_CHECK_MACRO)
    write_basic_package_version_file(${made}/CleftConfigVersion.cmake COMPATIBILITY SameMajorVersion)
    configure_file(${PROJECT_SOURCE_DIR}/src/cmake/CleftStaticDependencies.cmake.in
        ${made}/Cleft-static-dependencies.cmake @ONLY)
    install(FILES ${made}/CleftConfig.cmake ${made}/CleftConfigVersion.cmake ${made}/Cleft-static-dependencies.cmake
        ${PROJECT_SOURCE_DIR}/src/cmake/FindTetGen.cmake ${PROJECT_SOURCE_DIR}/src/cmake/FindDeflate.cmake
        DESTINATION ${CLEFT_INSTALL_CMAKEDIR} COMPONENT development)
endfunction()

# cleft_install_io(LIBRARY...): the file component, built on these libraries.
function(cleft_install_io)
    if(NOT CLEFT_INSTALL)
        return()
    endif()
    cleft_find_libraries_from(cleft_io_shared ${CMAKE_INSTALL_LIBDIR})
    cleft_install_library(cleft_io_shared io-shared io io_development)
    cleft_install_library(cleft_io_static io-static io_development io_development)
    set_target_properties(cleft_io_shared PROPERTIES EXPORT_NAME io_shared)
    set_target_properties(cleft_io_static PROPERTIES EXPORT_NAME io_static)
    cleft_install_headers(io_development cleft_io.h cleft_io.hpp cleft_io_parts.h)

    cleft_link_flags(cleft_io_private_libs ${ARGN})
    cleft_install_pkgconfig(cleft-io io_development)

    string(REPLACE " " ";" io_libraries "${cleft_io_private_libs}")
    # Flags, not CMake packages, of which not every library has one.
    set(dependencies ${PROJECT_BINARY_DIR}/install/Cleft-io-static-dependencies.cmake)
    configure_file(${PROJECT_SOURCE_DIR}/src/cmake/CleftIoStaticDependencies.cmake.in ${dependencies} @ONLY)
    install(FILES ${dependencies} DESTINATION ${CLEFT_INSTALL_CMAKEDIR} COMPONENT io_development)
endfunction()

# The component for MPI, which is a shared library alone, as those of MPI mostly are.
function(cleft_install_mpi)
    if(NOT CLEFT_INSTALL)
        return()
    endif()
    cleft_find_libraries_from(cleft_mpi_shared ${CMAKE_INSTALL_LIBDIR})
    cleft_install_library(cleft_mpi_shared mpi mpi mpi_development)
    cleft_install_headers(mpi_development cleft_mpi.h)
    cleft_install_pkgconfig(cleft-mpi mpi_development)
endfunction()

# cleft_install_mpi_command(MANUAL): as cleft_install_command().
function(cleft_install_mpi_command manual)
    if(NOT CLEFT_INSTALL)
        return()
    endif()
    cleft_find_libraries_from(cleft_mpi_cli ${CMAKE_INSTALL_BINDIR})
    install(TARGETS cleft_mpi_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT mpi_command)
    if(manual)
        install(DIRECTORY ${manual}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT mpi_command)
    endif()
endfunction()

# cleft_install_command(MANUAL): the command, its completion and, if there is one, the folder of its manual pages.
function(cleft_install_command manual)
    if(NOT CLEFT_INSTALL)
        return()
    endif()
    cleft_find_libraries_from(cleft_cli ${CMAKE_INSTALL_BINDIR})
    install(TARGETS cleft_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT command)
    install(FILES ${PROJECT_SOURCE_DIR}/src/cli/cleft.bash
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME cleft COMPONENT command)
    if(manual)
        install(DIRECTORY ${manual}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT command)
    endif()
endfunction()

# cleft_install_fortran(MODULE_FOLDER SOURCES IO_SOURCES): the modules as compiled, and their sources for other
# compilers.
function(cleft_install_fortran modules sources io_sources)
    if(NOT CLEFT_INSTALL)
        return()
    endif()
    cleft_install_library(cleft_fortran fortran-compiled fortran fortran)
    install(DIRECTORY ${modules}/ DESTINATION ${CLEFT_INSTALL_MODULEDIR} COMPONENT fortran)
    install(FILES ${sources} ${io_sources} DESTINATION ${CMAKE_INSTALL_DATADIR}/cleft/fortran COMPONENT fortran)
    cleft_install_pkgconfig(cleft-fortran fortran)

    set(made ${PROJECT_BINARY_DIR}/install/Cleft-fortran.cmake)
    configure_package_config_file(${PROJECT_SOURCE_DIR}/src/cmake/CleftFortran.cmake.in ${made}
        INSTALL_DESTINATION ${CLEFT_INSTALL_CMAKEDIR} PATH_VARS CMAKE_INSTALL_DATADIR CLEFT_INSTALL_MODULEDIR
        NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
    install(FILES ${made} DESTINATION ${CLEFT_INSTALL_CMAKEDIR} COMPONENT fortran)
endfunction()
