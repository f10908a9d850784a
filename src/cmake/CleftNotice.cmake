# What a build is made of, and under which licences: stated once, where a library is found, and put into every package.

# cleft_builds_on(PART NAME LICENCE): PART (a library, the command) of this build has NAME in it or is linked with it.
function(cleft_builds_on part name licence)
    set_property(GLOBAL APPEND PROPERTY CLEFT_BUILT_ON "  ${part}: ${name}, ${licence}")
endfunction()

# Writes NOTICE into the build folder, from where it is installed; after all of src has been configured. The licence of
# the whole, as packages have it in one line, is the global property CLEFT_LICENCE.
function(cleft_write_notice)
    get_property(CLEFT_BUILT_ON GLOBAL PROPERTY CLEFT_BUILT_ON)
    list(JOIN CLEFT_BUILT_ON "\n" CLEFT_BUILT_ON)
    set(licence MIT)
    set(CLEFT_CONSEQUENCES "")
    if(CLEFT_WITH_TETGEN)
        set(licence "MIT AND AGPL-3.0-or-later")
        file(READ ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/NoticeTetGen.txt CLEFT_CONSEQUENCES)
    endif()
    set_property(GLOBAL PROPERTY CLEFT_LICENCE ${licence})
    configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/Notice.txt.in ${PROJECT_BINARY_DIR}/install/NOTICE @ONLY)
endfunction()
