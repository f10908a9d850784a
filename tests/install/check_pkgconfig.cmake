# Are the .pc files valid, do they name private libraries where they are needed and only there, and can a C compiler
# build PROGRAM by them, from the installed tree and from the build tree?
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})

function(pkg_config variable)
    execute_process(COMMAND pkg-config ${ARGN}
        OUTPUT_VARIABLE output OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    set(${variable} "${output}" PARENT_SCOPE)
endfunction()

function(expect_private library flags static_flags)
    if("${flags} " MATCHES "-l${library} " OR NOT "${static_flags} " MATCHES "-l${library} ")
        message(FATAL_ERROR "${library} must be named with --static alone: \"${flags}\", \"${static_flags}\"")
    endif()
endfunction()

function(build_by name)
    list(JOIN ARGN " " flags)
    separate_arguments(flags UNIX_COMMAND "${flags}")
    execute_process(COMMAND ${COMPILER} ${PROGRAM} ${flags} -o ${FOLDER}/${name} COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND ${FOLDER}/${name} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Does the program load libcleft.so?
function(expect_needed name wanted)
    execute_process(COMMAND ldd ${FOLDER}/${name} OUTPUT_VARIABLE needed COMMAND_ERROR_IS_FATAL ANY)
    string(FIND "${needed}" "libcleft.so" place)
    set(found TRUE)
    if(place EQUAL -1)
        set(found FALSE)
    endif()
    if(NOT found STREQUAL wanted)
        message(FATAL_ERROR "${name} needs: ${needed}")
    endif()
endfunction()

set(ENV{PKG_CONFIG_PATH} ${INSTALLED})
file(GLOB files ${INSTALLED}/*.pc)
foreach(file ${files})
    pkg_config(ignored --validate ${file})
endforeach()

pkg_config(flags --cflags --libs cleft)
pkg_config(static_flags --static --cflags --libs cleft)
pkg_config(libdir --variable=libdir cleft)
expect_private(stdc.. "${flags}" "${static_flags}")
if(TETGEN)
    expect_private(tet "${flags}" "${static_flags}")
endif()
build_by(shared ${flags} -Wl,-rpath,${libdir})
# --static names what the library needs, but a linker takes libcleft.so for -lcleft where there is one.
build_by(told_static ${static_flags} -Wl,-rpath,${libdir})
expect_needed(told_static TRUE)
string(REPLACE "-lcleft " "-l:libcleft.a " static_flags "${static_flags}")
build_by(static ${static_flags})
expect_needed(static FALSE)

# Without the flags there must be no way, or the test would prove nothing.
execute_process(COMMAND ${COMPILER} ${PROGRAM} -o ${FOLDER}/none RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
if(result EQUAL 0)
    message(FATAL_ERROR "the program can be built without the flags of pkg-config")
endif()

set(ENV{PKG_CONFIG_PATH} ${UNINSTALLED})
pkg_config(flags --cflags --libs cleft)
pkg_config(libdir --variable=libdir cleft)
build_by(uninstalled ${flags} -Wl,-rpath,${libdir})
