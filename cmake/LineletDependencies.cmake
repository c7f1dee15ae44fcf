# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The dependencies of linelet. The PCL classes need only four small components of PCL:
# every other one (io, features, surface) brings VTK, Qt and MPI into each consumer's
# build.

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
if(LINELET_WITH_PCL)
  find_package(PCL 1.13 REQUIRED COMPONENTS common octree kdtree search)
endif()
find_package(Boost 1.74 REQUIRED)
find_package(HWY REQUIRED CONFIG)
find_package(nanoflann 1.4 REQUIRED CONFIG) # headers that only our sources include
if(LINELET_WITH_OPENMP)
  find_package(OpenMP REQUIRED COMPONENTS CXX)
endif()
if(LINELET_WITH_OPENCL AND LINELET_WITH_PCL)
  find_package(OpenCL 1.2)
  if(OpenCL_FOUND)
    message(STATUS "linelet: OpenCL engine: yes (${OpenCL_LIBRARIES})")
  else()
    message(STATUS "linelet: OpenCL engine: no (OpenCL not found)")
  endif()
endif()
if(LINELET_BUILD_IO AND LINELET_WITH_HDF5)
  # Only the C library: FindHDF5 would call a compiler wrapper, and pull in MPI where that
  # flavor is installed as well.
  find_path(LINELET_HDF5_INCLUDE hdf5.h PATH_SUFFIXES hdf5/serial)
  find_library(LINELET_HDF5_LIBRARY NAMES hdf5_serial hdf5)
  find_package(ZLIB) # chunks are inflated once, as a check, before HDF5 reads them
  if(LINELET_HDF5_INCLUDE AND LINELET_HDF5_LIBRARY AND ZLIB_FOUND)
    set(LINELET_HDF5_FOUND ON)
    message(STATUS "linelet: HDF5 files: yes (${LINELET_HDF5_LIBRARY})")
  else()
    message(STATUS "linelet: HDF5 files: no (libhdf5-dev not found)")
  endif()
endif()
if(LINELET_BUILD_IO)
  find_package(liblzf REQUIRED CONFIG) # compressed PCD
  find_package(GDAL REQUIRED)
  find_package(Ceres REQUIRED)
  # Headers that only our sources include.
  find_path(MUSTACHE_INCLUDE_DIR kainjow/mustache.hpp REQUIRED)
endif()
if(LINELET_BUILD_IO OR LINELET_BUILD_APPS)
  find_package(nlohmann_json 3.9 REQUIRED)
endif()
if(LINELET_BUILD_APPS OR LINELET_BUILD_VIEWER OR LINELET_BUILD_TESTS)
  find_package(CLI11 REQUIRED)
endif()
if(LINELET_BUILD_VIEWER OR LINELET_BUILD_TESTS)
  find_package(Threads REQUIRED)
endif()
if(LINELET_BUILD_APPS AND LINELET_BUILD_BENCH)
  # Pictures: drawing, text and PNG, without a display.
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo)
endif()
if(LINELET_BUILD_VIEWER OR (LINELET_BUILD_TESTS AND LINELET_BUILD_APPS))
  find_package(Qt5 5.15 QUIET COMPONENTS Widgets)
  if(Qt5_FOUND)
    find_package(VTK 9 QUIET COMPONENTS CommonDataModel FiltersCore FiltersSources
      GUISupportQt RenderingCore RenderingOpenGL2)
  endif()
  if(TARGET Qt5::Widgets AND TARGET VTK::GUISupportQt)
    set(LINELET_BUILD_VIEWER ON)
  elseif(LINELET_BUILD_VIEWER)
    message(FATAL_ERROR "linelet-view needs VTK 9 with Qt 5 (libvtk9-qt-dev, "
      "qtbase5-dev); install them, or leave out LINELET_BUILD_VIEWER")
  endif()
endif()
if(LINELET_BUILD_TESTS)
  find_package(GTest REQUIRED)
endif()
