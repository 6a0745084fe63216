# The library as a target that others may export: a project that carries the sources and exports a library which links
# this one names hardsphere::hardsphere there, and finds it installed. With HSP_INSTALL off nothing is installed unless
# the component hardsphere_development is asked for.
set(HSP_BY_DEFAULT EXCLUDE_FROM_ALL)
if(HSP_INSTALL)
  set(HSP_BY_DEFAULT "")
endif()
set(HSP_PACKAGE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/hardsphere)
install(TARGETS hardsphere EXPORT hardsphere-targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT hardsphere_development ${HSP_BY_DEFAULT}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT hardsphere_runtime
    NAMELINK_COMPONENT hardsphere_development ${HSP_BY_DEFAULT}
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT hardsphere_runtime ${HSP_BY_DEFAULT})
install(EXPORT hardsphere-targets NAMESPACE hardsphere:: DESTINATION ${HSP_PACKAGE_FOLDER}
  COMPONENT hardsphere_development ${HSP_BY_DEFAULT})
export(EXPORT hardsphere-targets NAMESPACE hardsphere:: FILE ${PROJECT_BINARY_DIR}/hardsphere-targets.cmake)
