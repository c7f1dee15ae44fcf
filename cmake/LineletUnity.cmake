# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
#
# With CMAKE_UNITY_BUILD, the sources of a folder are compiled as one, since most of the
# time goes into headers that they share. Highway's kernels include themselves once per
# instruction set and stay separate; CMake itself separates sources that have their own
# compiler settings.
get_property(targets GLOBAL PROPERTY LINELET_TARGETS)
foreach(target IN LISTS targets)
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  # GCC treats an included source as a header, whose types must not use unnamed ones.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  get_target_property(root ${target} SOURCE_DIR)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(source ${source} ABSOLUTE BASE_DIR ${root})
    file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${source})
    get_filename_component(folder ${folder} DIRECTORY)
    string(MAKE_C_IDENTIFIER "${folder}" folder)
    if(NOT source MATCHES "_kernels.cpp$")
      set_source_files_properties(${source} TARGET_DIRECTORY ${target}
        PROPERTIES UNITY_GROUP ${folder})
    endif()
  endforeach()
endforeach()
