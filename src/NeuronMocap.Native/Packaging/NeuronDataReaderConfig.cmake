# find_package(NeuronDataReader CONFIG): the target NeuronDataReader::NeuronDataReader, wherever the folder lies.
cmake_policy(PUSH)
cmake_policy(VERSION 3.10)
include("${CMAKE_CURRENT_LIST_DIR}/NeuronDataReaderTargets.cmake")
cmake_policy(POP)
