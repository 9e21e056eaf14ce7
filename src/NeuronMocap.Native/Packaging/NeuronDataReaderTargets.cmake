# NeuronDataReaderConfig.cmake sets the paths of the files: _ndr_library, _ndr_import (Windows) and _ndr_include.
foreach(_ndr_file "${_ndr_library}" "${_ndr_import}" "${_ndr_include}/NeuronDataReader.h")
    if(_ndr_file AND NOT EXISTS "${_ndr_file}")
        set(NeuronDataReader_FOUND FALSE)
        set(NeuronDataReader_NOT_FOUND_MESSAGE "${_ndr_file} is missing.")
    endif()
endforeach()

if(NOT DEFINED NeuronDataReader_NOT_FOUND_MESSAGE AND NOT TARGET NeuronDataReader::NeuronDataReader)
    add_library(NeuronDataReader::NeuronDataReader SHARED IMPORTED)
    set_target_properties(NeuronDataReader::NeuronDataReader PROPERTIES
        IMPORTED_LOCATION "${_ndr_library}"
        INTERFACE_INCLUDE_DIRECTORIES "${_ndr_include}")

    # Programs load the name of the major version, which every later library of that version has.
    if(WIN32)
        set_property(TARGET NeuronDataReader::NeuronDataReader PROPERTY IMPORTED_IMPLIB "${_ndr_import}")
    elseif(APPLE)
        set_property(TARGET NeuronDataReader::NeuronDataReader PROPERTY IMPORTED_SONAME "@rpath/libNeuronDataReader.1.dylib")
    else()
        set_property(TARGET NeuronDataReader::NeuronDataReader PROPERTY IMPORTED_SONAME "libNeuronDataReader.so.1")
    endif()
endif()

unset(_ndr_file)
unset(_ndr_library)
unset(_ndr_import)
unset(_ndr_include)
unset(_ndr_prefix)
