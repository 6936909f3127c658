# Finds the packages that Riedel is built with. All that are missing stand in one message, with their names in Debian,
# Spack and conda-forge and, where there is one, the option that does without.
set(riedel_missing "")

# riedel_package(<name> <Debian> <Spack> <conda-forge> <option or ""> [what find_package takes behind the name])
macro(riedel_package name debian spack conda_forge without)
  find_package(${name} ${ARGN} QUIET)
  if(NOT ${name}_FOUND)
    string(APPEND riedel_missing "\n  ${name}: Debian ${debian}, Spack ${spack}, conda-forge ${conda_forge}")
    if(NOT "${without}" STREQUAL "")
      string(APPEND riedel_missing "; to do without: ${without}")
    endif()
  endif()
endmacro()

# Headers of Riedel show these, so that a project around this one must see their targets.
set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)
riedel_package(Eigen3 libeigen3-dev eigen eigen "" 3.4)
riedel_package(OpenMP "libomp-dev (clang; g++ has it)" llvm-openmp llvm-openmp "" COMPONENTS CXX)
riedel_package(nlohmann_json nlohmann-json3-dev nlohmann-json nlohmann_json "" 3.11)
set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL OFF)

riedel_package(xsimd libxsimd-dev xsimd xsimd "") # headers only; its target asks for a library, xtl, that nobody needs
riedel_package(tomlplusplus libtomlplusplus-dev tomlplusplus tomlplusplus "" 3)
riedel_package(ZLIB zlib1g-dev zlib zlib "")
if(RIEDEL_BUILD_APPS)
  riedel_package(Boost "libboost-dev and libboost-program-options-dev" "boost +program_options" libboost-devel "" 1.74
                 COMPONENTS program_options)
else()
  riedel_package(Boost libboost-dev boost libboost-devel "" 1.74)
endif()
if(RIEDEL_WITH_CGAL)
  set(asked "${BUILD_TESTING}")
  riedel_package(CGAL libcgal-dev cgal cgal-cpp "-DRIEDEL_WITH_CGAL=OFF")
  if(asked STREQUAL "")
    unset(BUILD_TESTING CACHE) # which CGAL turns off for everybody
  endif()
endif()
if(RIEDEL_WITH_VTK)
  riedel_package(VTK libvtk9-dev vtk vtk "-DRIEDEL_WITH_VTK=OFF" 9
                 COMPONENTS CommonCore CommonDataModel IOXML IOImage RenderingCore RenderingFreeType)
endif()
if(RIEDEL_BUILD_TESTS)
  riedel_package(GTest "libgtest-dev and libgmock-dev" googletest gtest "-DRIEDEL_BUILD_TESTS=OFF")
endif()

if(riedel_missing)
  message(FATAL_ERROR "Riedel needs packages that CMake does not find (older versions than it asks for count as missing):"
                      "${riedel_missing}\nOn Debian and Ubuntu apps/install_packages installs them all. A package in a "
                      "folder of its own is found through CMAKE_PREFIX_PATH.")
endif()
