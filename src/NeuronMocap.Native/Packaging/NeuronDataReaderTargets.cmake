if(TARGET NeuronDataReader::NeuronDataReader)
    return()
endif()

# The real path: /lib may be a link to /usr/lib, and the headers are in /usr/include.
get_filename_component(_ndr_prefix "${CMAKE_CURRENT_LIST_DIR}" REALPATH)
get_filename_component(_ndr_prefix "${_ndr_prefix}/../../.." ABSOLUTE)

# Programs take the file by the name of its major version, which every later library of that version has.
if(WIN32)
    set(_ndr_library "${_ndr_prefix}/bin/NeuronDataReader.dll")
elseif(APPLE)
    set(_ndr_library "${_ndr_prefix}/lib/libNeuronDataReader.1.dylib")
else()
    set(_ndr_library "${_ndr_prefix}/lib/libNeuronDataReader.so.1")
endif()

add_library(NeuronDataReader::NeuronDataReader SHARED IMPORTED)
set_target_properties(NeuronDataReader::NeuronDataReader PROPERTIES
    IMPORTED_LOCATION "${_ndr_library}"
    INTERFACE_INCLUDE_DIRECTORIES "${_ndr_prefix}/include")
if(WIN32)
    set_property(TARGET NeuronDataReader::NeuronDataReader PROPERTY IMPORTED_IMPLIB "${_ndr_prefix}/lib/NeuronDataReader.lib")
elseif(APPLE)
    set_property(TARGET NeuronDataReader::NeuronDataReader PROPERTY IMPORTED_SONAME "@rpath/libNeuronDataReader.1.dylib")
else()
    set_property(TARGET NeuronDataReader::NeuronDataReader PROPERTY IMPORTED_SONAME "libNeuronDataReader.so.1")
endif()

foreach(_ndr_file "${_ndr_library}" "${_ndr_prefix}/include/NeuronDataReader.h")
    if(NOT EXISTS "${_ndr_file}")
        message(FATAL_ERROR "NeuronDataReader is not complete: ${_ndr_file} is missing.")
    endif()
endforeach()

unset(_ndr_file)
unset(_ndr_library)
unset(_ndr_prefix)
