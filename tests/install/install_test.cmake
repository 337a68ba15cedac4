# Installs BUILD below PREFIX and demands that the program there takes its data from there.
file(REMOVE_RECURSE ${PREFIX})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${PREFIX}/${DATA}/vigil/baseq2/marker.cfg "echo these are the installed data\n")
execute_process(COMMAND ${PREFIX}/${BIN}/vigil +set vid_driver headless +exec marker.cfg +quit
  WORKING_DIRECTORY ${PREFIX} OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE status)
string(FIND "${said}" "these are the installed data" found)
if(NOT status EQUAL 0 OR found EQUAL -1)
  message(FATAL_ERROR "the installed program ended with ${status} and looked elsewhere for its data:\n${said}")
endif()
file(REMOVE_RECURSE ${PREFIX})
