# Installed files, as four components: hardsphere_runtime (the program, its manual page, completion for shells, a shared
# library), hardsphere_development (archive, headers, CMake package, pkg-config file, Fortran module) and
# hardsphere_documentation. With a shared library hardsphere_python too: the module, from where it finds that library.

# The headers of what was built, of which components.h says what that is.
set(HSP_LEFT_OUT_HEADERS components)
foreach(component ${HSP_LEFT_OUT})
  list(APPEND HSP_LEFT_OUT_HEADERS ${HSP_${component}_HEADERS})
endforeach()
list(JOIN HSP_LEFT_OUT_HEADERS "|" HSP_LEFT_OUT_HEADERS)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  COMPONENT hardsphere_development FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp"
  REGEX "/hardsphere/(${HSP_LEFT_OUT_HEADERS})\\.h$" EXCLUDE)
file(READ ${PROJECT_SOURCE_DIR}/include/hardsphere/components.h text)
foreach(component ${HSP_LEFT_OUT})
  string(TOUPPER HSP_HAS_${component} macro)
  string(REPLACE "${macro} 1" "${macro} 0" text "${text}")
endforeach()
file(CONFIGURE OUTPUT components.h CONTENT "${text}" @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/components.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/hardsphere
  COMPONENT hardsphere_development)

# Without what users cannot ask for.
set(HSP_PACKED_COMPONENTS ${HSP_ALL_COMPONENTS})
list(REMOVE_ITEM HSP_PACKED_COMPONENTS ${HSP_LEFT_OUT} wide)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/hardsphere-config.cmake.in hardsphere-config.cmake
  INSTALL_DESTINATION ${HSP_PACKAGE_FOLDER})
# A minor version takes programs for an older one from 1.0 on.
set(compatibility SameMajorVersion)
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(compatibility SameMinorVersion)
endif()
write_basic_package_version_file(hardsphere-config-version.cmake COMPATIBILITY ${compatibility})
list(JOIN HSP_PACKED_COMPONENTS " " HSP_PC_COMPONENTS)
configure_file(${CMAKE_CURRENT_LIST_DIR}/hardsphere.pc.in hardsphere.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/hardsphere-config.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/hardsphere-config-version.cmake DESTINATION ${HSP_PACKAGE_FOLDER}
  COMPONENT hardsphere_development)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/hardsphere.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  COMPONENT hardsphere_development)

# The Fortran modules' source is part of every package: what is compiled of it (see fortran/CMakeLists.txt) serves one
# compiler only.
if(EXISTS ${HSP_FORTRAN_FOLDER}/hardsphere.f90)
  install(FILES ${HSP_FORTRAN_FOLDER}/hardsphere.f90 ${HSP_FORTRAN_FOLDER}/hardsphere_workspace.f90
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/hardsphere COMPONENT hardsphere_development)
endif()
# Declarations without a preprocessor, for cffi and others.
install(FILES ${PROJECT_SOURCE_DIR}/capi/interface/hardsphere.cdef ${PROJECT_SOURCE_DIR}/capi/bindings/hardsphere.rs
  ${PROJECT_SOURCE_DIR}/capi/bindings/hardsphere.jl DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/hardsphere
  COMPONENT hardsphere_development)
install(FILES ${PROJECT_SOURCE_DIR}/capi/fortran/hardsphere-fortran.cmake DESTINATION ${HSP_PACKAGE_FOLDER}
  COMPONENT hardsphere_development)

if(BUILD_SHARED_LIBS)
  set(HSP_PYTHON_FOLDER ${CMAKE_INSTALL_LIBDIR}/python3/dist-packages CACHE STRING "Where the Python module goes")
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/capi/python/hardsphere DESTINATION ${HSP_PYTHON_FOLDER}
    COMPONENT hardsphere_python FILES_MATCHING PATTERN "*.py" PATTERN "py.typed")
  install(FILES ${PROJECT_SOURCE_DIR}/capi/clients/lammps_fix.py DESTINATION ${HSP_PYTHON_FOLDER}/hardsphere
    COMPONENT hardsphere_python)
endif()

if(HSP_TOOL)
  install(TARGETS hardsphere_tool RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT hardsphere_runtime)
  # The program writes its manual page and what makes shells complete its options, where it can run, or HSP_NATIVE_TOOL.
  find_program(HSP_BASH bash)
  set(HSP_NATIVE_TOOL "" CACHE FILEPATH "For a cross compiler: the same program for this machine, which writes its manual page")
  set(writer "${HSP_NATIVE_TOOL}")
  if(NOT writer AND NOT CMAKE_CROSSCOMPILING)
    set(writer $<TARGET_FILE:hardsphere_tool>)
  endif()
  if(HSP_BASH AND writer)
    set(written ${CMAKE_CURRENT_BINARY_DIR}/hardsphere)
    install(CODE "
      execute_process(COMMAND \"${writer}\" completion bash OUTPUT_FILE \"${written}.bash\")
      execute_process(COMMAND \"${writer}\" completion zsh OUTPUT_FILE \"${written}.zsh\")
      execute_process(COMMAND \"${HSP_BASH}\" \"${PROJECT_SOURCE_DIR}/capi/program/app/man_page.sh\"
        \"${writer}\" OUTPUT_FILE \"${written}.1\")" COMPONENT hardsphere_runtime)
    install(FILES ${written}.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT hardsphere_runtime)
    install(FILES ${written}.bash RENAME hardsphere
      DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT hardsphere_runtime)
    install(FILES ${written}.zsh RENAME _hardsphere
      DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT hardsphere_runtime)
  endif()
endif()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT hardsphere_documentation)

# Pages, whose links are made to fit; what they show and link to: pictures, examples, and a molecule for these.
set(HSP_PAGES_FOLDER ${CMAKE_CURRENT_BINARY_DIR}/pages)
install(CODE "
  set(SOURCE \"${PROJECT_SOURCE_DIR}\")
  set(FOLDER \"${HSP_PAGES_FOLDER}\")
  set(DOCUMENTATION \"${CMAKE_INSTALL_FULL_DOCDIR}\")
  set(HEADERS \"${CMAKE_INSTALL_FULL_INCLUDEDIR}\")
  include(\"${CMAKE_CURRENT_LIST_DIR}/installed_pages.cmake\")" COMPONENT hardsphere_documentation)
install(DIRECTORY ${HSP_PAGES_FOLDER}/ DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT hardsphere_documentation)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/capi/guide DESTINATION ${CMAKE_INSTALL_DOCDIR}
  COMPONENT hardsphere_documentation FILES_MATCHING PATTERN "*.svg")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/tests/program/pictures/ ${PROJECT_SOURCE_DIR}/tests/differential/scans/
  DESTINATION ${CMAKE_INSTALL_DOCDIR}/guide/pictures COMPONENT hardsphere_documentation FILES_MATCHING PATTERN "*.svg")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/capi/examples ${PROJECT_SOURCE_DIR}/capi/clients DESTINATION ${CMAKE_INSTALL_DOCDIR}
  COMPONENT hardsphere_documentation)
install(FILES ${PROJECT_SOURCE_DIR}/bench/molecules/crambin.pdb DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples
  COMPONENT hardsphere_documentation)
