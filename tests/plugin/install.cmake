# cmake -DBUILD=… -DPREFIX=… -P install.cmake: installs into an empty folder, without the files of an earlier version.
file(REMOVE_RECURSE ${PREFIX})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX} COMMAND_ERROR_IS_FATAL ANY)
