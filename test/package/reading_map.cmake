# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Every header named in doc/reading.md exists.
file(GLOB_RECURSE headers RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/include/linelet/*.h
  ${SOURCE_DIR}/src/*.h ${SOURCE_DIR}/apps/*.h ${SOURCE_DIR}/bench/*.h)
string(REPLACE ";" " " headers ";${headers};")
file(READ ${SOURCE_DIR}/doc/reading.md text)
string(REGEX MATCHALL "[a-z_/]+\\.h" named "${text}")
if(NOT named)
  message(FATAL_ERROR "doc/reading.md names no header")
endif()
foreach(name IN LISTS named)
  string(FIND "${headers}" "/${name} " found)
  if(found EQUAL -1)
    message(FATAL_ERROR "doc/reading.md names ${name}, which does not exist")
  endif()
endforeach()
