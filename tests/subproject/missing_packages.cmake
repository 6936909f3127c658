# cmake -DSOURCE=… -DBUILD=… -P missing_packages.cmake: without three of its packages Riedel stops with one message that
# names them all, how systems call them, and how to do without.
file(REMOVE_RECURSE ${BUILD})
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${BUILD} -G Ninja -DCMAKE_CXX_COMPILER=${COMPILER}
                        -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON -DCMAKE_DISABLE_FIND_PACKAGE_CGAL=ON
                        -DCMAKE_DISABLE_FIND_PACKAGE_tomlplusplus=ON
                RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE told)
file(REMOVE_RECURSE ${BUILD})
if(NOT failed)
  message(FATAL_ERROR "it goes on without them")
endif()
string(REGEX REPLACE "[ \n]+" " " told "${told}")
foreach(part "VTK: Debian libvtk9-dev, Spack vtk, conda-forge vtk; to do without: -DRIEDEL_WITH_VTK=OFF"
             "CGAL: Debian libcgal-dev, Spack cgal, conda-forge cgal-cpp; to do without: -DRIEDEL_WITH_CGAL=OFF"
             "tomlplusplus: Debian libtomlplusplus-dev, Spack tomlplusplus, conda-forge tomlplusplus")
  string(FIND "${told}" "${part}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "'${part}' is not in: ${told}")
  endif()
endforeach()
