# The files by which pkg-config and its kin find the library: one set to install, one to use the build tree.

# cleft_link_flags(VARIABLE LIBRARY...): what a linker needs of libraries, given as targets or files: -lNAME, after
# -LFOLDER where the folder is none that it searches by itself.
function(cleft_link_flags variable)
    set(flags)
    foreach(library ${ARGN})
        if(TARGET ${library})
            get_target_property(library ${library} LOCATION)
        endif()
        get_filename_component(folder ${library} DIRECTORY)
        get_filename_component(name ${library} NAME)
        string(REGEX REPLACE "^lib(.*)\\.(so|a|dylib)(\\.[0-9.]+)?$" "\\1" name ${name})
        if(NOT folder IN_LIST CMAKE_C_IMPLICIT_LINK_DIRECTORIES)
            list(APPEND flags -L${folder})
        endif()
        list(APPEND flags -l${name})
    endforeach()
    list(REMOVE_DUPLICATES flags)
    list(JOIN flags " " flags)
    set(${variable} "${flags}" PARENT_SCOPE)
endfunction()

# cleft_cxx_runtime(VARIABLE): the libraries that a C++ compiler links by itself and a C compiler does not.
function(cleft_cxx_runtime variable)
    set(libraries ${CMAKE_CXX_IMPLICIT_LINK_LIBRARIES})
    list(REMOVE_ITEM libraries ${CMAKE_C_IMPLICIT_LINK_LIBRARIES})
    list(REMOVE_DUPLICATES libraries)
    set(${variable} ${libraries} PARENT_SCOPE)
endfunction()

function(cleft_below_prefix variable folder)
    if(IS_ABSOLUTE "${folder}")
        set(${variable} ${folder} PARENT_SCOPE)
    else()
        set(${variable} \${prefix}/${folder} PARENT_SCOPE)
    endif()
endfunction()

# cleft_install_pkgconfig(NAME COMPONENT): installs NAME.pc, which finds the prefix from where it lies itself, so that
# the tree can be moved (an absolute CMAKE_INSTALL_LIBDIR pins it instead), and makes NAME-uninstalled.pc in
# BUILD/pkgconfig, which pkg-config prefers to NAME.pc, for use without installing.
function(cleft_install_pkgconfig name component)
    set(template ${PROJECT_SOURCE_DIR}/pkgconfig/${name}.pc.in)
    set(target_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
    if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
        set(prefix ${CMAKE_INSTALL_PREFIX})
    else()
        file(RELATIVE_PATH up /prefix/${target_folder} /prefix)
        string(REGEX REPLACE "/$" "" up ${up})
        set(prefix \${pcfiledir}/${up})
    endif()
    cleft_below_prefix(libdir "${CMAKE_INSTALL_LIBDIR}")
    cleft_below_prefix(includedir "${CMAKE_INSTALL_INCLUDEDIR}")
    cleft_below_prefix(moduledir "${CLEFT_INSTALL_MODULEDIR}")
    configure_file(${template} ${PROJECT_BINARY_DIR}/install/${name}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/install/${name}.pc DESTINATION ${target_folder} COMPONENT ${component})

    set(prefix ${PROJECT_BINARY_DIR})
    set(libdir ${CMAKE_CURRENT_BINARY_DIR})
    set(includedir ${PROJECT_SOURCE_DIR}/include)
    set(moduledir ${CMAKE_CURRENT_BINARY_DIR}/modules)
    configure_file(${template} ${PROJECT_BINARY_DIR}/pkgconfig/${name}-uninstalled.pc @ONLY)
endfunction()
