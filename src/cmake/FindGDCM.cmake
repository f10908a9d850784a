# Finds GDCM 3, the reader of compressed DICOM: GDCM_LIBRARIES, GDCM_INCLUDE_DIR. Its own package files want its tools.
find_path(GDCM_INCLUDE_DIR gdcmImageReader.h PATH_SUFFIXES gdcm-3.0)
set(found)
foreach(part MSFF DICT IOD DSED Common)
    find_library(GDCM_${part}_LIBRARY NAMES gdcm${part})
    mark_as_advanced(GDCM_${part}_LIBRARY)
    list(APPEND found GDCM_${part}_LIBRARY)
endforeach()
mark_as_advanced(GDCM_INCLUDE_DIR)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(GDCM REQUIRED_VARS ${found} GDCM_INCLUDE_DIR)

if(GDCM_FOUND)
    set(GDCM_LIBRARIES)
    foreach(library ${found})
        list(APPEND GDCM_LIBRARIES ${${library}})
    endforeach()
endif()
