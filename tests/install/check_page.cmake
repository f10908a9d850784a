# Builds and runs the first program of a guide: the first ```LANGUAGE block of PAGE.
file(READ ${PAGE} page)
string(REGEX MATCH "```${LANGUAGE}\n(([^`]|`[^`])*)```" found "${page}")
file(WRITE ${FILE} "${CMAKE_MATCH_1}")

set(ENV{PKG_CONFIG_PATH} ${PKGCONFIG})
execute_process(COMMAND pkg-config --cflags --libs ${PACKAGE} OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE)
execute_process(COMMAND pkg-config --variable=libdir cleft OUTPUT_VARIABLE libdir OUTPUT_STRIP_TRAILING_WHITESPACE)
separate_arguments(flags UNIX_COMMAND "${flags}")
execute_process(COMMAND ${COMPILER} -Wall -Werror ${FILE} ${flags} -Wl,-rpath,${libdir} -o ${FILE}.program
    COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${FILE}.program OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
if(NOT output MATCHES "[1-9][0-9]+ +tetrahedra")
    message(FATAL_ERROR "printed: ${output}")
endif()
