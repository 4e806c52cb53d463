# A room: one folder, one namespace, one static library of the same name (sim/knot -> sim_knot).
#   carrel_room(sim_knot [EVERY_TICK|SELDOM] SOURCES a.cpp b.cpp [APART b.cpp] MAY_INCLUDE sim_geometry LIBRARIES Foo::Foo)
# APART: sources with names of their own that others of the room have as well; a unity build, as in `make`, compiles those alone.
# MAY_INCLUDE becomes the link dependency; tests/walls.cmake fails on an include that crosses any other wall.
function(carrel_room name)
  cmake_parse_arguments(ROOM "EVERY_TICK;SELDOM" "" "SOURCES;APART;MAY_INCLUDE;LIBRARIES" ${ARGN})
  carrel_apart(${ROOM_APART})
  add_library(${name} STATIC ${ROOM_SOURCES})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC ${ROOM_MAY_INCLUDE} PRIVATE ${ROOM_LIBRARIES})
  # Marking every temporary vector as it comes and goes makes a sanitized drill 2.5 times slower: where a tick's time goes
  # that one check is left out, all others stay. Such a room cannot share headers that were precompiled with it.
  get_target_property(common sim_geometry PRECOMPILE_HEADERS)
  if(ROOM_EVERY_TICK AND CARREL_SANITIZE)
    target_compile_options(${name} PRIVATE -fno-sanitize-address-use-after-scope)
    target_precompile_headers(${name} PRIVATE ${common})
  # What no tick calls costs more to compile than to run: sanitized builds optimise it less.
  elseif(ROOM_SELDOM AND CARREL_SANITIZE)
    target_compile_options(${name} PRIVATE -O1)
    if(name STREQUAL scenarios_drill)
      target_precompile_headers(${name} PRIVATE ${common})
    else()
      target_precompile_headers(${name} REUSE_FROM scenarios_drill)
    endif()
  elseif(NOT name STREQUAL sim_geometry)
    target_precompile_headers(${name} REUSE_FROM sim_geometry)
  endif()
endfunction()

# Sources in which headers of JSON or the command line cost all the time to compile and none to run: sanitized builds do
# not optimise them.
function(carrel_quick_to_compile)
  if(CARREL_SANITIZE)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -O0 SKIP_PRECOMPILE_HEADERS ON)
  endif()
endfunction()

# Sources that a unity build compiles alone. CMake does so by itself with those that have options of their own.
function(carrel_apart)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
