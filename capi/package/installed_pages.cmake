# Writes README, the list of changes and the guide as they are installed: into FOLDER, with links that lead to what is
# installed. Of links to anything else in the sources the words are left. install.cmake runs it when pages are installed.
#   SOURCE, FOLDER           the sources, and where to write
#   DOCUMENTATION, HEADERS   where the documentation and the headers are installed

# Installed folders and files, and where they go. The first row that fits counts.
set(installed
  "README.md" "${DOCUMENTATION}/README.md"
  "LICENSE" "${DOCUMENTATION}/LICENSE"
  ".github/CHANGELOG.md" "${DOCUMENTATION}/CHANGELOG.md"
  "capi/guide" "${DOCUMENTATION}/guide"
  "capi/examples" "${DOCUMENTATION}/examples"
  "capi/clients" "${DOCUMENTATION}/clients"
  "bench/molecules/crambin.pdb" "${DOCUMENTATION}/examples/crambin.pdb"
  "tests/program/pictures" "${DOCUMENTATION}/guide/pictures"
  "tests/differential/scans/bond_scans.svg" "${DOCUMENTATION}/guide/pictures/bond_scans.svg"
  "tests/differential/scans/curvature/window_scans.svg" "${DOCUMENTATION}/guide/pictures/curvature/window_scans.svg"
  "include" "${HEADERS}")

# Where a file of the sources is installed; empty if it is not.
function(installed_path file result)
  set(rows ${installed})
  while(rows)
    list(POP_FRONT rows from to)
    string(FIND "${file}/" "${from}/" at)
    if(at EQUAL 0)
      string(LENGTH "${from}" length)
      string(SUBSTRING "${file}" ${length} -1 rest)
      set(${result} "${to}${rest}" PARENT_SCOPE)
      return()
    endif()
  endwhile()
  set(${result} "" PARENT_SCOPE)
endfunction()

# Writes the page to where it is installed.
function(install_page page)
  installed_path(${page} place)
  get_filename_component(page_folder ${SOURCE}/${page} DIRECTORY)
  get_filename_component(place_folder ${place} DIRECTORY)
  file(READ ${SOURCE}/${page} rest)
  set(text "")
  while(rest MATCHES "!?\\[([^][]*)\\]\\(([^() ]+)\\)")
    set(link "${CMAKE_MATCH_0}")
    set(words "${CMAKE_MATCH_1}")
    set(target "${CMAKE_MATCH_2}")
    string(FIND "${rest}" "${link}" at)
    string(SUBSTRING "${rest}" 0 ${at} before)
    string(LENGTH "${link}" length)
    math(EXPR at "${at} + ${length}")
    string(SUBSTRING "${rest}" ${at} -1 rest)
    if(NOT target MATCHES "^(https?:|#)")
      string(REGEX MATCH "#.*$" anchor "${target}")
      string(REGEX REPLACE "#.*$" "" file "${target}")
      get_filename_component(file ${file} ABSOLUTE BASE_DIR ${page_folder})
      file(RELATIVE_PATH file ${SOURCE} ${file})
      installed_path(${file} to)
      if(to STREQUAL "")
        set(link "${words}")
      else()
        file(RELATIVE_PATH to ${place_folder} ${to})
        string(REPLACE "](${target})" "](${to}${anchor})" link "${link}")
      endif()
    endif()
    string(APPEND text "${before}${link}")
  endwhile()
  file(RELATIVE_PATH place ${DOCUMENTATION} ${place})
  file(WRITE ${FOLDER}/${place} "${text}${rest}")
endfunction()

file(REMOVE_RECURSE ${FOLDER})
file(GLOB guide RELATIVE ${SOURCE} ${SOURCE}/capi/guide/*.md)
foreach(page README.md .github/CHANGELOG.md ${guide})
  install_page(${page})
endforeach()
