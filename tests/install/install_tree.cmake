# Installs BUILD into a prefix that is given relative to FOLDER, looks at it, and moves it to FOLDER/moved.
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix first
    WORKING_DIRECTORY ${FOLDER} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

# Nothing in it may know where it was built or installed.
file(GLOB_RECURSE texts ${FOLDER}/first/*.cmake ${FOLDER}/first/*.pc ${FOLDER}/first/*.h ${FOLDER}/first/*.f90)
foreach(text ${texts})
    file(READ ${text} content)
    foreach(place ${BUILD} ${SOURCE} ${FOLDER})
        string(FIND "${content}" "${place}" found)
        if(NOT found EQUAL -1)
            message(FATAL_ERROR "${text} names ${place}")
        endif()
    endforeach()
endforeach()

# The names of the shared library: for the linker, for the loader, and its own.
string(REGEX MATCH "^[0-9]+" soversion ${VERSION})
set(libdir ${FOLDER}/first/${LIBDIR})
foreach(link libcleft.so libcleft.so.${soversion})
    file(READ_SYMLINK ${libdir}/${link} target)
    if(IS_ABSOLUTE ${target} OR NOT EXISTS ${libdir}/${target})
        message(FATAL_ERROR "${link} leads to ${target}")
    endif()
endforeach()
foreach(file libcleft.so.${VERSION} libcleft.a pkgconfig/cleft.pc cmake/Cleft/CleftConfig.cmake)
    if(NOT EXISTS ${libdir}/${file})
        message(FATAL_ERROR "${LIBDIR}/${file} is not there")
    endif()
endforeach()

file(RENAME ${FOLDER}/first ${FOLDER}/moved)

# DESTDIR goes before an absolute prefix.
execute_process(COMMAND ${CMAKE_COMMAND} -E env DESTDIR=${FOLDER}/destdir
    ${CMAKE_COMMAND} --install ${BUILD} --prefix /opt/cleft OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE moved RELATIVE ${FOLDER}/moved ${FOLDER}/moved/*)
file(GLOB_RECURSE staged RELATIVE ${FOLDER}/destdir/opt/cleft ${FOLDER}/destdir/*)
if(NOT moved STREQUAL staged)
    message(FATAL_ERROR "with DESTDIR other files are installed: ${staged}")
endif()
file(REMOVE_RECURSE ${FOLDER}/destdir)
