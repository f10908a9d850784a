# Debian packages of the install tree, by `cpack -G DEB` in the build folder: one for each component. Configured with
# CMAKE_INSTALL_PREFIX=/usr, libraries go into the multiarch folder.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR Cleft)
set(CPACK_PACKAGE_CONTACT "The Cleft maintainers <maintainers@cleft.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_CLEFT_NOTICE ${PROJECT_BINARY_DIR}/install/NOTICE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/CleftDebian.cmake)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/src ${PROJECT_BINARY_DIR}/src/io
    ${PROJECT_BINARY_DIR}/src/mpi)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")

# cleft_package(COMPONENT NAME SECTION TEXT [NEEDS COMPONENT...] [DEPENDS|RECOMMENDS|SUGGESTS PACKAGE...])
function(cleft_package component name section text)
    cmake_parse_arguments(package "" "" "NEEDS;DEPENDS;RECOMMENDS;SUGGESTS" ${ARGN})
    string(TOUPPER ${component} upper)
    set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name} PARENT_SCOPE)
    set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section} PARENT_SCOPE)
    string(CONCAT description
        "Cleft makes conforming meshes of tetrahedra from labelled volumes, such as\n"
        "segmented scans and microstructures.\n\n${text}")
    set(CPACK_COMPONENT_${upper}_DESCRIPTION "${description}" PARENT_SCOPE)
    set(CPACK_COMPONENT_${upper}_DEPENDS ${package_NEEDS} PARENT_SCOPE)
    foreach(relation DEPENDS RECOMMENDS SUGGESTS)
        list(JOIN package_${relation} ", " packages)
        set(CPACK_DEBIAN_${upper}_PACKAGE_${relation} "${packages}" PARENT_SCOPE)
    endforeach()
endfunction()

# What the static libraries need is recommended, for few link them.
set(static_io libdeflate-dev zlib1g-dev libtiff-dev libpng-dev libjpeg-dev)
if(CLEFT_WITH_GDCM)
    list(APPEND static_io libgdcm-dev)
endif()
if(CLEFT_WITH_TETGEN)
    set(static libtet1.5-dev)
endif()
cleft_package(runtime libcleft0 libs "This package has the library that programs use.")
cleft_package(development libcleft-dev libdevel
    "This package has the header, the static library, the CMake package and the\npkg-config file."
    NEEDS runtime RECOMMENDS ${static})
cleft_package(io libcleft-io0 libs "This package has the component that reads and writes files." NEEDS runtime)
cleft_package(io_development libcleft-io-dev libdevel
    "This package has what is needed to build programs that read and write files."
    NEEDS io development RECOMMENDS ${static_io})
cleft_package(command cleft science "This package has the command." NEEDS io)
cleft_package(mpi libcleft-mpi0 libs "This package has the component for processes that share a mesh by MPI."
    NEEDS runtime)
cleft_package(mpi_development libcleft-mpi-dev libdevel
    "This package has what is needed to build programs whose processes share a mesh."
    NEEDS mpi development DEPENDS libopenmpi-dev)
cleft_package(mpi_command cleft-mpi science "This package has the command that makes meshes on several processes."
    NEEDS mpi io DEPENDS openmpi-bin)
cleft_package(fortran libcleft-fortran-dev libdevel "This package has the Fortran modules."
    NEEDS development RECOMMENDS libcleft-io-dev SUGGESTS gfortran)
cleft_package(java_native libcleft-jni java "This package has the native part of the Java package." NEEDS io)
cleft_package(java libcleft-java java "This package has the Java package org.cleft."
    NEEDS java_native SUGGESTS "default-jre-headless (>= 2:1.17)")
cleft_package(csharp libcleft-cil cli-mono "This package has the .NET assembly." NEEDS io DEPENDS mono-runtime)
if(CLEFT_BUILD_PYTHON)  # compiled modules are for one version of Python
    find_package(Python3 REQUIRED COMPONENTS Interpreter)
    math(EXPR next "${Python3_VERSION_MINOR} + 1")
    cleft_package(python python3-cleft python "This package has the Python package." NEEDS io
        DEPENDS "python3 (>= 3.${Python3_VERSION_MINOR})" "python3 (<< 3.${next})" python3-numpy
        SUGGESTS python3-matplotlib python3-meshio)
endif()

# The loader learns of new libraries by a trigger.
file(WRITE ${PROJECT_BINARY_DIR}/install/triggers "activate-noawait ldconfig\n")
foreach(component RUNTIME IO MPI)
    set(CPACK_DEBIAN_${component}_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/install/triggers)
endforeach()

get_cmake_property(CPACK_COMPONENTS_ALL COMPONENTS)
list(REMOVE_ITEM CPACK_COMPONENTS_ALL Unspecified)
include(CPack)
