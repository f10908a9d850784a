# What every target of the project is compiled with.
# No contraction into fused multiply-adds: the same bytes whatever the compiler makes of an expression.
function(cleft_compile_settings target)
    target_compile_features(${target} PUBLIC cxx_std_17)
    set_target_properties(${target} PROPERTIES
        CXX_EXTENSIONS OFF C_STANDARD 99 C_EXTENSIONS OFF
        CXX_VISIBILITY_PRESET hidden C_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
        POSITION_INDEPENDENT_CODE ON)
    target_compile_options(${target} PRIVATE -ffp-contract=off -Wall -Wextra -Wpedantic -Wconversion
        $<$<BOOL:${CLEFT_WARNINGS_AS_ERRORS}>:-Werror>)
    # Where several sources are compiled as one, gcc takes their anonymous namespaces for those of a header.
    get_target_property(unity ${target} UNITY_BUILD)
    target_compile_options(${target} PRIVATE
        $<$<AND:$<BOOL:${unity}>,$<COMPILE_LANG_AND_ID:CXX,GNU>>:-Wno-subobject-linkage>)
    # errno is never read after a mathematical function: let sqrt be an instruction.
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O3 -fno-math-errno>)
    target_compile_definitions(${target} PRIVATE $<$<BOOL:${CLEFT_ASSERTIONS}>:CLEFT_ASSERTIONS>)
    if(CLEFT_SANITIZE)
        target_compile_options(${target} PRIVATE -fsanitize=${CLEFT_SANITIZE} -fno-omit-frame-pointer
            -fno-sanitize-recover=all)
        target_link_options(${target} PUBLIC -fsanitize=${CLEFT_SANITIZE})
    endif()
endfunction()

# What a shared library shows: its SONAME, and the functions of its version script alone. The SONAME changes only when a
# function is removed or changed, which tests/abi guards against.
function(cleft_shared_interface target version_script)
    set_target_properties(${target} PROPERTIES
        VERSION ${PROJECT_VERSION} SOVERSION 0 LINK_DEPENDS ${version_script})
    target_link_options(${target} PRIVATE
        LINKER:--version-script=${version_script} LINKER:--as-needed LINKER:--no-undefined)
endfunction()
