# The target hardsphere_documentation: the public headers and the guides as HTML, by Doxygen, into documentation/html of the build folder. A
# warning is an error. It is built on demand alone.
find_package(Doxygen REQUIRED)

# The headers are written to be read as they are: each opens with a plain comment, drawings and tables included, which the
# filter hands over as it stands.
set(dark_pictures ${PROJECT_BINARY_DIR}/documentation/pictures)
file(MAKE_DIRECTORY ${dark_pictures})
set(DOXYGEN_FILTER_PATTERNS "*.h=awk -f ${CMAKE_CURRENT_LIST_DIR}/opening_comment.awk"
  "*.md=awk -v dark=${dark_pictures} -f ${CMAKE_CURRENT_LIST_DIR}/guide_links.awk")
set(DOXYGEN_IMAGE_PATH ${PROJECT_SOURCE_DIR}/capi/guide ${PROJECT_SOURCE_DIR}/tests/program/pictures
  ${PROJECT_SOURCE_DIR}/tests/differential/scans ${PROJECT_SOURCE_DIR}/tests/differential/scans/curvature
  ${dark_pictures})
set(DOXYGEN_PROJECT_BRIEF ${PROJECT_DESCRIPTION})
set(DOXYGEN_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/documentation)
set(DOXYGEN_OPTIMIZE_OUTPUT_FOR_C YES)
set(DOXYGEN_JAVADOC_AUTOBRIEF YES)
set(DOXYGEN_MACRO_EXPANSION YES)
set(DOXYGEN_EXPAND_ONLY_PREDEF YES)
set(DOXYGEN_PREDEFINED HSP_API= HSP_CALL=)
set(DOXYGEN_STRIP_FROM_INC_PATH ${PROJECT_SOURCE_DIR}/include)
set(DOXYGEN_STRIP_FROM_PATH ${PROJECT_SOURCE_DIR}/include)
set(DOXYGEN_SORT_MEMBER_DOCS NO)
set(DOXYGEN_SORT_BRIEF_DOCS NO)
set(DOXYGEN_VERBATIM_HEADERS NO)
set(DOXYGEN_GENERATE_LATEX NO)
set(DOXYGEN_HAVE_DOT NO)
set(DOXYGEN_QUIET YES)
set(DOXYGEN_EXTRACT_ALL NO)
# It has its description as a plain comment, and the C interface has the rest.
set(DOXYGEN_EXCLUDE_PATTERNS "*/hardsphere.hpp")
# Parameters are described in sentences.
set(DOXYGEN_WARN_NO_PARAMDOC NO)
set(DOXYGEN_WARN_AS_ERROR FAIL_ON_WARNINGS)
doxygen_add_docs(hardsphere_documentation ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/capi/guide)
# The gallery has its pictures before a dark page beside the others, where there is a program that draws them.
if(HSP_TOOL)
  add_custom_target(hardsphere_dark_pictures COMMAND bash ${CMAKE_CURRENT_LIST_DIR}/dark_pictures.sh
    ${PROJECT_SOURCE_DIR} ${dark_pictures} $<TARGET_FILE:hardsphere_tool> VERBATIM)
  add_dependencies(hardsphere_documentation hardsphere_dark_pictures)
endif()
