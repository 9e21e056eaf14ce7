# find_package(NeuronDataReader CONFIG): the target NeuronDataReader::NeuronDataReader, wherever the folder is.
# Uses the real path: /lib may be a link to /usr/lib, but the headers are in /usr/include.
get_filename_component(_ndr_prefix "${CMAKE_CURRENT_LIST_DIR}" REALPATH)
get_filename_component(_ndr_prefix "${_ndr_prefix}/../../.." ABSOLUTE)

set(_ndr_include "${_ndr_prefix}/include")
if(WIN32)
    set(_ndr_library "${_ndr_prefix}/bin/NeuronDataReader.dll")
    set(_ndr_import "${_ndr_prefix}/lib/NeuronDataReader.lib")
elseif(APPLE)
    set(_ndr_library "${_ndr_prefix}/lib/libNeuronDataReader.1.dylib")
else()
    set(_ndr_library "${_ndr_prefix}/lib/libNeuronDataReader.so.1")
endif()

include("${CMAKE_CURRENT_LIST_DIR}/NeuronDataReaderTargets.cmake")
