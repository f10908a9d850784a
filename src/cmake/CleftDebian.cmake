# Run by CPack before it packs: what Debian wants in each package besides the installed files (Policy 12.1, 12.5, 12.7).
find_program(gzip gzip REQUIRED)
function(compress)
    execute_process(COMMAND ${gzip} -9nf ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# The file of copyrights, of which programs can read the fields: the notice of the build is its comment.
function(fold path output)
    file(READ ${path} text)
    string(REGEX REPLACE "^.*(Permission is)" "\\1" text "${text}")  # of the licence: without title and copyright
    string(STRIP "${text}" text)
    string(REGEX REPLACE "\n[ \t]*\n" "\n.\n" text "${text}")
    string(REPLACE "\n" "\n " text "${text}")
    set(${output} " ${text}" PARENT_SCOPE)
endfunction()
fold(${CPACK_RESOURCE_FILE_LICENSE} licence)
fold(${CPACK_CLEFT_NOTICE} notice)
file(STRINGS ${CPACK_RESOURCE_FILE_LICENSE} holder REGEX "^Copyright")
string(REPLACE "Copyright (c) " "" holder "${holder}")
set(copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: Cleft
Comment:
${notice}

Files: *
Copyright: ${holder}
License: Expat
${licence}
")
string(TIMESTAMP today "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(component ${CPACK_COMPONENTS_ALL})
    string(TOUPPER ${component} upper)
    set(name ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
    set(staged ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr)

    file(GLOB manual ${staged}/share/man/man*/*.[1-9])
    if(manual)
        compress(${manual})
    endif()
    file(REMOVE ${staged}/share/doc/cleft/LICENSE ${staged}/share/doc/cleft/NOTICE)
    file(GLOB record ${staged}/lib/python3/dist-packages/*.dist-info/RECORD)
    if(record)  # which files there are, dpkg knows
        get_filename_component(dist_info ${record} DIRECTORY)
        file(REMOVE ${record} ${dist_info}/LICENSE ${dist_info}/NOTICE)
        file(WRITE ${dist_info}/INSTALLER "debian\n")
    endif()
    file(WRITE ${staged}/share/doc/${name}/copyright "${copyright}")
    file(WRITE ${staged}/share/doc/${name}/changelog.Debian
        "cleft (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium\n\n"
        "  * Packaged by CPack.\n\n"
        " -- ${CPACK_PACKAGE_CONTACT}  ${today}\n")
    compress(${staged}/share/doc/${name}/changelog.Debian)
endforeach()
