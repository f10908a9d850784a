# What the Python, Java and C# packages share: SWIG makes the low level of each from the interface in this folder, and
# the classes on top are written by hand.
find_package(SWIG 4.1 REQUIRED)

# SWIG must know what int64_t is: `long` where that has 64 bits, but for macOS.
set(cleft_swig_flags)
if(CMAKE_SIZEOF_VOID_P EQUAL 8 AND NOT WIN32 AND NOT APPLE)
    set(cleft_swig_flags -DSWIGWORDSIZE64)
endif()

# cleft_swig_module(TARGET INTERFACE LIBRARY FOLDER SWIG_FLAG...): a module TARGET of the C that SWIG makes of
# swig/INTERFACE.i, linked with LIBRARY; what SWIG writes in the language itself goes to FOLDER.
function(cleft_swig_module target interface library folder)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${target}.c)
    file(GLOB interface_files CONFIGURE_DEPENDS
        ${PROJECT_SOURCE_DIR}/bindings/swig/*.i ${PROJECT_SOURCE_DIR}/include/cleft/*.h)
    add_custom_command(OUTPUT ${source}
        COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
        COMMAND ${SWIG_EXECUTABLE} ${ARGN} ${cleft_swig_flags} -I${PROJECT_SOURCE_DIR}/include
            -outdir ${folder} -o ${source} ${PROJECT_SOURCE_DIR}/bindings/swig/${interface}.i
        DEPENDS ${interface_files}
        COMMENT "Wrapping ${interface}.i in ${target}"
        VERBATIM)
    add_library(${target} MODULE ${source})
    target_link_libraries(${target} PRIVATE ${library})
    set_target_properties(${target} PROPERTIES C_VISIBILITY_PRESET hidden)
endfunction()

# cleft_copy_to(TARGET FOLDER FILE...): a target that keeps copies of the files, given relative to here, in FOLDER.
function(cleft_copy_to target folder)
    set(copies)
    foreach(file ${ARGN})
        get_filename_component(name ${file} NAME)
        add_custom_command(OUTPUT ${folder}/${name}
            COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_CURRENT_SOURCE_DIR}/${file} ${folder}/${name}
            DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${file})
        list(APPEND copies ${folder}/${name})
    endforeach()
    add_custom_target(${target} ALL DEPENDS ${copies})
endfunction()

# cleft_find_libraries_here_or_from(TARGET FOLDER): a module finds our libraries beside itself, as in the packages of
# the languages, or where they are installed, as seen from FOLDER.
function(cleft_find_libraries_here_or_from target folder)
    cleft_find_libraries_from(${target} ${folder})
    get_target_property(rpath ${target} INSTALL_RPATH)
    set_target_properties(${target} PROPERTIES INSTALL_RPATH "\$ORIGIN;${rpath}")
endfunction()

# The steps that put the installed files of components under FOLDER, for packages to be made of.
function(cleft_staging_commands variable folder)
    set(commands COMMAND ${CMAKE_COMMAND} -E rm -rf ${folder})
    foreach(component ${ARGN})
        list(APPEND commands COMMAND ${CMAKE_COMMAND} -E env DESTDIR=${folder}
            ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --component ${component} --prefix /usr)
    endforeach()
    set(${variable} ${commands} PARENT_SCOPE)
endfunction()
