execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE output ERROR_VARIABLE errors RESULT_VARIABLE result)
if(result EQUAL 0 OR output MATCHES "went on" OR NOT errors MATCHES "cleft: .*gradation")
    message(FATAL_ERROR "result ${result}, \"${output}\", \"${errors}\"")
endif()
