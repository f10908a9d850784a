# Installs into lib64, a multiarch folder and an absolute one, and builds PROGRAM against each by pkg-config and by
# CMake. Configuring anew is cheap; what it would compile is taken from BUILD, since only the places differ.
file(REMOVE_RECURSE ${FOLDER})

function(run)
    execute_process(COMMAND ${ARGN} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(check_layout name libdir prefix)
    set(build ${FOLDER}/${name}/build)
    run(${CMAKE_COMMAND} -S ${SOURCE} -B ${build} -G ${GENERATOR} -DCMAKE_BUILD_TYPE=Release
        -DCMAKE_INSTALL_LIBDIR=${libdir}
        -DCMAKE_INSTALL_PREFIX=${FOLDER}/${name}/first -DCLEFT_WITH_TETGEN=${TETGEN}
        -DCLEFT_BUILD_TESTS=OFF -DCLEFT_WITH_IO=OFF -DCLEFT_BUILD_CLI=OFF -DCLEFT_BUILD_FORTRAN=OFF)
    file(GLOB libraries ${BUILD}/src/libcleft.*)
    file(COPY ${libraries} DESTINATION ${build}/src)
    run(${CMAKE_COMMAND} --install ${build})
    if(NOT prefix STREQUAL first)
        file(RENAME ${FOLDER}/${name}/first ${FOLDER}/${name}/${prefix})
    endif()

    cmake_path(ABSOLUTE_PATH libdir BASE_DIRECTORY ${FOLDER}/${name}/${prefix})
    if(NOT EXISTS ${libdir}/libcleft.so OR NOT EXISTS ${libdir}/cmake/Cleft/CleftConfig.cmake)
        message(FATAL_ERROR "${libdir} is not where the library is")
    endif()
    set(ENV{PKG_CONFIG_PATH} ${libdir}/pkgconfig)
    execute_process(COMMAND pkg-config --cflags --libs cleft
        OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    separate_arguments(flags UNIX_COMMAND "${flags}")
    run(${COMPILER} ${PROGRAM} ${flags} -Wl,-rpath,${libdir} -o ${FOLDER}/${name}/program)
    run(${FOLDER}/${name}/program)

    set(where -DCleft_DIR=${libdir}/cmake/Cleft)
    if(name STREQUAL multiarch)  # Debian's CMake looks into no other of the three by itself
        set(where -DCMAKE_PREFIX_PATH=${FOLDER}/${name}/${prefix})
    endif()
    set(consumer ${FOLDER}/${name}/consumer)
    run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${consumer} -G ${GENERATOR} -DPROGRAM=${PROGRAM}
        ${where})
    run(${CMAKE_COMMAND} --build ${consumer})
    run(${consumer}/consumer)
endfunction()

check_layout(lib64 lib64 moved)
check_layout(multiarch lib/x86_64-linux-gnu moved)
check_layout(absolute ${FOLDER}/absolute/libraries first)
