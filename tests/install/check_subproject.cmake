# Has a project that takes Cleft in as a subproject what it needs, and nothing else: no tests of Cleft, no files of
# Cleft in its install tree unless it asks for them? Compiling all anew would take minutes: the build is only planned.
file(REMOVE_RECURSE ${FOLDER})
set(build ${FOLDER}/build)

function(run)
    execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
    set(output "${output}" PARENT_SCOPE)
endfunction()

function(configure)
    run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/parent -B ${build} -G ${GENERATOR} -DCLEFT=${SOURCE}
        -DPROGRAM=${PROGRAM}
        -DCMAKE_BUILD_TYPE=Release -DCLEFT_WITH_TETGEN=${TETGEN} ${ARGN})
endfunction()

function(expect what found wanted)
    if(NOT found MATCHES "${wanted}")
        message(FATAL_ERROR "${what}: ${found}")
    endif()
endfunction()

# The libraries that would be installed.
function(installed variable)
    file(GLOB_RECURSE scripts ${build}/_deps/cleft-build/cmake_install.cmake)
    set(found)
    foreach(script ${scripts})
        file(STRINGS ${script} lines REGEX "libcleft")
        list(APPEND found ${lines})
    endforeach()
    set(${variable} "${found}" PARENT_SCOPE)
endfunction()

configure(-DBUILD_SHARED_LIBS=ON)
run(${CMAKE_COMMAND} --build ${build} --target parent --verbose -- -n)
expect("the program is not linked with the shared library" "${output}" "libcleft\\.so\\.0")
if(output MATCHES "cmocka|_test|libcleft_io")
    message(FATAL_ERROR "more than the library is built: ${output}")
endif()
run(${CMAKE_CTEST_COMMAND} --test-dir ${build} -N)
expect("not only the test of the parent" "${output}" "Total Tests: 1\n")
installed(libraries)
expect("Cleft is installed, unasked" "${libraries}" "^$")

configure(-DBUILD_SHARED_LIBS=OFF -DCLEFT_INSTALL=ON)
run(${CMAKE_COMMAND} --build ${build} --target parent --verbose -- -n)
expect("the program is not linked with the static library" "${output}" "libcleft\\.a")
installed(libraries)
expect("Cleft is not installed, though asked for" "${libraries}" "libcleft\\.so\\.0")

if(IO)
    foreach(shared ON OFF)
        configure(-DBUILD_SHARED_LIBS=${shared} -DCLEFT_INSTALL=OFF -DCLEFT_WITH_IO=ON)
        run(${CMAKE_COMMAND} --build ${build} --target parent --verbose -- -n)
        expect("the program is not linked with Cleft::io" "${output}" "libcleft_io\\.(so|a)")
        run(${CMAKE_COMMAND} --build ${build} --target help)
        if(output MATCHES "cleft_cli")
            message(FATAL_ERROR "the command is built, unasked")
        endif()
    endforeach()
endif()
