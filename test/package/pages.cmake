# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Links between pages resolve, and the pipeline shown in doc/pcl.md is the program that
# is built.
file(GLOB pages ${SOURCE_DIR}/*.md ${SOURCE_DIR}/doc/*.md)
set(dead)
foreach(page IN LISTS pages)
  get_filename_component(folder ${page} DIRECTORY)
  file(READ ${page} text)
  string(REPLACE "](" "@(" text "${text}") # brackets would hide the semicolons of a list
  string(REGEX MATCHALL "@\\([^)# ]+" links "${text}")
  foreach(link IN LISTS links)
    string(SUBSTRING "${link}" 2 -1 link)
    if(NOT link MATCHES "^https?:" AND NOT EXISTS ${folder}/${link})
      list(APPEND dead "${page}: ${link}")
    endif()
  endforeach()
endforeach()
if(dead)
  list(JOIN dead "\n  " dead)
  message(FATAL_ERROR "These links are dead:\n  ${dead}")
endif()

file(READ ${SOURCE_DIR}/doc/pcl.md page)
file(READ ${SOURCE_DIR}/apps/pcl_chain_example.cpp program)
string(FIND "${program}" "#include" start)
string(SUBSTRING "${program}" ${start} -1 program)
string(FIND "${page}" "${program}" found)
if(found EQUAL -1)
  message(FATAL_ERROR "doc/pcl.md does not show apps/pcl_chain_example.cpp as it is")
endif()
