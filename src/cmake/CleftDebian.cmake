# Run by CPack before it packs: what Debian wants in each package besides the installed files (Policy 12.1, 12.5, 12.7).
find_program(gzip gzip REQUIRED)
function(compress)
    execute_process(COMMAND ${gzip} -9nf ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(READ ${CPACK_RESOURCE_FILE_LICENSE} licence)
string(TIMESTAMP today "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(component ${CPACK_COMPONENTS_ALL})
    string(TOUPPER ${component} upper)
    set(name ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
    set(staged ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr)

    file(GLOB manual ${staged}/share/man/man*/*.[1-9])
    if(manual)
        compress(${manual})
    endif()
    file(REMOVE ${staged}/share/doc/cleft/LICENSE)
    file(GLOB record ${staged}/lib/python3/dist-packages/*.dist-info/RECORD)
    if(record)  # which files there are, dpkg knows
        get_filename_component(dist_info ${record} DIRECTORY)
        file(REMOVE ${record} ${dist_info}/LICENSE)
        file(WRITE ${dist_info}/INSTALLER "debian\n")
    endif()
    file(WRITE ${staged}/share/doc/${name}/copyright "Cleft\n\n${licence}")
    file(WRITE ${staged}/share/doc/${name}/changelog.Debian
        "cleft (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium\n\n"
        "  * Packaged by CPack.\n\n"
        " -- ${CPACK_PACKAGE_CONTACT}  ${today}\n")
    compress(${staged}/share/doc/${name}/changelog.Debian)
endforeach()
