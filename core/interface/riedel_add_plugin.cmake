# riedel_add_plugin(name source.cpp...): a plug-in name.so for Riedel's program, compiled like its own libraries, so
# that a law gives identical results at the same speed.
function(riedel_add_plugin name)
  add_library(${name} MODULE ${ARGN})
  target_link_libraries(${name} PRIVATE riedel::core)
  target_compile_options(${name} PRIVATE -fno-math-errno -fno-trapping-math
                                                $<$<CXX_COMPILER_ID:GNU>:--param=avoid-fma-max-bits=0>)
  set_target_properties(${name} PROPERTIES PREFIX "" SUFFIX .so CXX_STANDARD 20 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF
                                           CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
endfunction()

# By default optimise: laws are ten times slower without.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release)
endif()

# riedel_add_umat(name source...): a shared library name.so with a subroutine UMAT, in Fortran, C or C++.
function(riedel_add_umat name)
  add_library(${name} MODULE ${ARGN})
  set_target_properties(${name} PROPERTIES PREFIX "" SUFFIX .so)
endfunction()
