# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
set(missing)
foreach(folder include src apps test bench)
  file(GLOB_RECURSE files ${SOURCE_DIR}/${folder}/*.h ${SOURCE_DIR}/${folder}/*.hpp
    ${SOURCE_DIR}/${folder}/*.cpp ${SOURCE_DIR}/${folder}/*.cl)
  foreach(file IN LISTS files)
    file(STRINGS ${file} lines LIMIT_COUNT 2)
    if(NOT "${lines}" MATCHES "SPDX-FileCopyrightText.*SPDX-License-Identifier: BSD-3")
      list(APPEND missing ${file})
    endif()
  endforeach()
endforeach()
if(missing)
  string(REPLACE ";" "\n  " missing "${missing}")
  message(FATAL_ERROR "These files lack the two license lines:\n  ${missing}")
endif()
