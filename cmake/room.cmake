# A room: one folder, one namespace, one static library of the same name (sim/knot -> sim_knot).
#   carrel_room(sim_knot SOURCES a.cpp b.cpp MAY_INCLUDE sim_geometry LIBRARIES Foo::Foo)
# MAY_INCLUDE becomes the link dependency; tests/walls.cmake fails on an include that crosses any other wall.
function(carrel_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;MAY_INCLUDE;LIBRARIES" ${ARGN})
  add_library(${name} STATIC ${ROOM_SOURCES})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC ${ROOM_MAY_INCLUDE} PRIVATE ${ROOM_LIBRARIES})
  if(NOT name STREQUAL sim_geometry)
    target_precompile_headers(${name} REUSE_FROM sim_geometry)
  endif()
endfunction()
