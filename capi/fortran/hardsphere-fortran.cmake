# Part of the installed package's configuration: the target hardsphere::hardsphere_fortran, for projects that have
# enabled Fortran. A .mod file is readable only by the compiler that wrote it. If that is this project's compiler, the
# compiled module is used; else the module's source becomes a library of this project.
get_property(hardsphere_languages GLOBAL PROPERTY ENABLED_LANGUAGES)
if(NOT "Fortran" IN_LIST hardsphere_languages)
  set(hardsphere_Fortran_FOUND FALSE)
  return()
endif()
set(hardsphere_Fortran_FOUND TRUE)
if(TARGET hardsphere::hardsphere_fortran)
  return()
endif()

set(hardsphere_fortran_compiled
  ${CMAKE_CURRENT_LIST_DIR}/hardsphere-fortran-${CMAKE_Fortran_COMPILER_ID}-${CMAKE_Fortran_COMPILER_VERSION}.cmake)
if(EXISTS ${hardsphere_fortran_compiled})
  include(${hardsphere_fortran_compiled})
else()
  get_target_property(hardsphere_include_folder hardsphere::hardsphere INTERFACE_INCLUDE_DIRECTORIES)
  add_library(hardsphere_fortran STATIC EXCLUDE_FROM_ALL ${hardsphere_include_folder}/hardsphere/hardsphere.f90
    ${hardsphere_include_folder}/hardsphere/hardsphere_workspace.f90)
  add_library(hardsphere::hardsphere_fortran ALIAS hardsphere_fortran)
  set_target_properties(hardsphere_fortran PROPERTIES POSITION_INDEPENDENT_CODE ON
    Fortran_MODULE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/hardsphere_modules)
  target_include_directories(hardsphere_fortran PUBLIC ${CMAKE_CURRENT_BINARY_DIR}/hardsphere_modules)
  target_link_libraries(hardsphere_fortran PUBLIC hardsphere::hardsphere)
endif()
