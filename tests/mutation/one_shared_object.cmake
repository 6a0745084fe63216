# Included by run.sh as CMAKE_PROJECT_INCLUDE: links the tests and the program to one shared object with everything that
# the library defines, instead of to the archive and to its objects. So a mutant costs the compilation of the files of
# the library that include the mutated one, and one link. A test is linked again only if it compiles the mutated file
# itself. The library is compiled with -O1 and with assertions, the rest as the build type says.

# All targets of a folder and of those below, in `targets`.
function(hsp_targets_below folder)
  get_property(found DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  get_property(subfolders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(subfolder ${subfolders})
    hsp_targets_below(${subfolder})
    list(APPEND found ${targets})
  endforeach()
  set(targets ${found} PARENT_SCOPE)
endfunction()

function(hsp_link_one_shared_object)
  hsp_targets_below(${PROJECT_SOURCE_DIR})

  set_target_properties(hardsphere_objects PROPERTIES CXX_VISIBILITY_PRESET default)
  target_compile_options(hardsphere_objects PRIVATE -O1 -UNDEBUG)
  # -Bsymbolic: a function of a header that is compiled into a test as well still has the mutant's body in the library.
  add_library(hardsphere_mutant SHARED $<TARGET_OBJECTS:hardsphere_objects>)
  set_target_properties(hardsphere_mutant PROPERTIES LINKER_LANGUAGE CXX)
  target_link_options(hardsphere_mutant PRIVATE -Wl,-Bsymbolic)
  target_link_libraries(hardsphere_mutant PRIVATE m)
  # A library can be exported only together with all libraries that it links to.
  install(TARGETS hardsphere_mutant EXPORT hardsphere-targets EXCLUDE_FROM_ALL)

  # The archive has no code of its own; it links to the shared object.
  set(nothing ${PROJECT_BINARY_DIR}/nothing.c)
  if(NOT EXISTS ${nothing})
    file(TOUCH ${nothing})
  endif()
  set_property(TARGET hardsphere PROPERTY SOURCES ${nothing})
  set_property(TARGET hardsphere APPEND PROPERTY INTERFACE_LINK_LIBRARIES $<BUILD_INTERFACE:hardsphere_mutant>)

  # In place of the objects, for targets that compile inner headers.
  add_library(hardsphere_inner INTERFACE)
  target_link_libraries(hardsphere_inner INTERFACE hardsphere_mutant)
  foreach(property INCLUDE_DIRECTORIES COMPILE_DEFINITIONS COMPILE_OPTIONS COMPILE_FEATURES)
    get_target_property(value hardsphere_objects INTERFACE_${property})
    if(value)
      set_target_properties(hardsphere_inner PROPERTIES INTERFACE_${property} "${value}")
    endif()
  endforeach()
  list(REMOVE_ITEM targets hardsphere_objects hardsphere)
  foreach(target ${targets})
    foreach(prefix "" INTERFACE_)
      get_target_property(linked ${target} ${prefix}LINK_LIBRARIES)
      get_target_property(sources ${target} ${prefix}SOURCES)
      if(linked)
        list(TRANSFORM linked REPLACE "^hardsphere_objects$" hardsphere_inner)
      else()
        set(linked)
      endif()
      if("$<TARGET_OBJECTS:hardsphere_objects>" IN_LIST sources)
        list(REMOVE_ITEM sources "$<TARGET_OBJECTS:hardsphere_objects>")
        list(APPEND linked hardsphere_mutant)
        set_property(TARGET ${target} PROPERTY ${prefix}SOURCES ${sources})
      endif()
      set_property(TARGET ${target} PROPERTY ${prefix}LINK_LIBRARIES ${linked})
    endforeach()
  endforeach()
endfunction()

cmake_language(DEFER CALL hsp_link_one_shared_object)
