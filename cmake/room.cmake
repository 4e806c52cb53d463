# A room: one folder, one namespace, one static library of the same name (sim/knot -> sim_knot).
#   carrel_room(sim_knot [EVERY_TICK|SELDOM] SOURCES a.cpp b.cpp [APART b.cpp] MAY_INCLUDE sim_geometry
#     [LIBRARIES Foo::Foo])
# EVERY_TICK, SELDOM: see flags.cmake.
# APART: sources with names of their own that others of the room have as well; a unity build compiles those alone.
# MAY_INCLUDE becomes the link dependency; tests/walls.cmake fails on an include that crosses any other wall.
function(carrel_room name)
  cmake_parse_arguments(ROOM "EVERY_TICK;SELDOM" "" "SOURCES;APART;MAY_INCLUDE;LIBRARIES" ${ARGN})
  carrel_apart(${ROOM_APART})
  add_library(${name} STATIC ${ROOM_SOURCES})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC ${ROOM_MAY_INCLUDE} PRIVATE ${ROOM_LIBRARIES})
  set(headers_of sim_geometry)
  if(ROOM_EVERY_TICK)
    carrel_every_tick(${name})
    if(CARREL_SANITIZE)
      set(headers_of ${name})
    endif()
  elseif(ROOM_SELDOM)
    carrel_seldom(${name})
    if(CARREL_SANITIZE)
      set(headers_of scenarios_drill)
    endif()
  endif()
  carrel_precompile(${name} ${headers_of})
endfunction()

# Headers of every room: reading these anew for each file takes two thirds of a build.
set(carrel_common_headers
  <Eigen/Core>
  <Eigen/Geometry>
  <algorithm>
  <array>
  <charconv>
  <cmath>
  <cstdint>
  <filesystem>
  <fstream>
  <functional>
  <iostream>
  <limits>
  <map>
  <memory>
  <numbers>
  <optional>
  <random>
  <set>
  <span>
  <sstream>
  <stdexcept>
  <string>
  <vector>)

# Precompiled headers are made by one target and serve all others with the same flags: carrel_precompile(name maker).
function(carrel_precompile name maker)
  if(name STREQUAL maker)
    target_precompile_headers(${name} PRIVATE ${carrel_common_headers} ${ARGN})
  else()
    target_precompile_headers(${name} REUSE_FROM ${maker})
  endif()
endfunction()

# Sources that a unity build compiles alone. CMake does so by itself with those that have options of their own.
function(carrel_apart)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
