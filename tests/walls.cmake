# The walls between the rooms: which room may include which, which library lives where, and what would make two runs
# of the simulation differ. Reads sources only, so it also sees files that no target builds yet.
#   cmake [-DROOT=source folder] -P walls.cmake     fails and names every crossing
cmake_minimum_required(VERSION 3.25)
if(NOT ROOT)
  get_filename_component(ROOT "${CMAKE_CURRENT_LIST_DIR}/.." ABSOLUTE)
endif()

# Which room sees which other folders or headers, as regular expressions on the path. `app` sees every room. A
# room within another comes before it: a file is of the first room that its path begins with.
set(rooms sim/geometry sim/rod sim/thread/contact sim/thread/ftl sim/thread/elastic sim/thread sim/knot
    tissue instruments assets scenarios/world scenarios/drill scenarios/recording scenarios/session app
    tests/bench/lab tests/bench/suites tests/bench/peers)
set(values sim/geometry/ instruments/tool[.]hpp)  # what a drill or a recording is made of: points, poses and jaws
set(sim/rod_sees sim/geometry/)
set(sim/thread/contact_sees sim/geometry/ sim/thread/def[.]hpp)
set(sim/thread/ftl_sees sim/geometry/ sim/thread/contact/ sim/thread/def[.]hpp)  # and not sim/thread/elastic
set(sim/thread/elastic_sees sim/geometry/ sim/rod/ sim/thread/contact/ sim/thread/def[.]hpp)  # and not sim/thread/ftl
set(sim/thread_sees sim/geometry/ sim/rod/ sim/thread/)
set(sim/knot_sees sim/geometry/)
set(tissue_sees sim/geometry/)
set(instruments_sees sim/geometry/)
set(assets_sees sim/geometry/)
set(scenarios/world_sees sim/ tissue/ instruments/ assets/)
set(scenarios/drill_sees ${values} scenarios/world/)
set(scenarios/recording_sees ${values} scenarios/world/ scenarios/drill/result[.]hpp)
set(scenarios/session_sees sim/ tissue/ instruments/ assets/ scenarios/)
set(app_sees sim/ tissue/ instruments/ assets/ scenarios/)
set(tests/bench/lab_sees sim/ tissue/ instruments/ assets/ scenarios/)
set(tests/bench/peers_sees sim/geometry/ tests/bench/lab/)
set(tests/bench/suites_sees sim/ tissue/ instruments/ assets/ scenarios/ app/draw/ app/play/picture[.]hpp tests/bench/)

# A library's headers and the only rooms (regular expressions on the file) that may include them.
set(libraries Bullet assimp graphics window SQLite zstd JSON OpenSSL)
set(Bullet_headers "bullet/|bt[A-Z]|(Bullet|Linear)[A-Za-z]*/")
set(Bullet_rooms "^(instruments|tests/bench/peers)/")
set(assimp_headers "assimp/")
set(assimp_rooms "^assets/")
set(graphics_headers "GL/|GLES|EGL/|png[.]h|CLI/")
set(graphics_rooms "^app/")
set(window_headers "SDL|imgui|backends/imgui")
set(window_rooms "^app/window/")
set(SQLite_headers "sqlite3")
set(SQLite_rooms "^scenarios/recording/")
set(zstd_headers "zstd")
set(zstd_rooms "^scenarios/recording/")
set(JSON_headers "nlohmann/")
set(JSON_rooms "^(scenarios/drill|app|tests)/")
set(OpenSSL_headers "openssl/")
set(OpenSSL_rooms "^scenarios/drill/")

# Same inputs, same bits: the C library's transcendental functions differ between its versions, hash order between runs.
# A bare log() is let through: the world writes its log of events by that name.
set(repeatable "^(sim|tissue|instruments|scenarios)/")
set(unrepeatable
    "std::(sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|exp|exp2|expm1|pow|log|log2|log10|log1p|cbrt|hypot)f? *[(]"
    "[^A-Za-z0-9_:.>](sin|cos|tan|asin|acos|atan|atan2|exp|pow|cbrt|hypot)f? *[(]"
    "[^A-Za-z0-9_]s?rand *[(]" "random_device" "unordered_(multi)?(map|set)" "#include *<(random|ctime|time[.]h)>")
set(clock "(std::|<)chrono")
set(clock_rooms "^scenarios/recording/")  # when to write to disk, never what

set(crossings 0)
function(crossing file text what)
  string(REGEX REPLACE "[\n\r]" "" text "${text}")
  message("${file}: ${text}: ${what}")
  math(EXPR crossings "${crossings} + 1")
  set(crossings ${crossings} PARENT_SCOPE)
endfunction()

# Into `result` the room that a path is of; none: nothing.
function(room_of path result)
  foreach(room IN LISTS rooms)
    if(path MATCHES "^${room}/")
      set(${result} "${room}" PARENT_SCOPE)
      return()
    endif()
  endforeach()
  set(${result} "" PARENT_SCOPE)
endfunction()

function(check_room_include file room header)
  room_of("${header}" other)
  if(other AND NOT other STREQUAL room)
    foreach(seen IN LISTS ${room}_sees)
      if(header MATCHES "^${seen}")
        return()
      endif()
    endforeach()
    crossing("${file}" "${header}" "${room} may not include ${other}")
  endif()
  set(crossings ${crossings} PARENT_SCOPE)
endfunction()

function(check_library_include file header)
  foreach(library IN LISTS libraries)
    if(header MATCHES "^(${${library}_headers})" AND NOT file MATCHES "${${library}_rooms}")
      crossing("${file}" "${header}" "${library} lives in ${${library}_rooms} alone")
    endif()
  endforeach()
  set(crossings ${crossings} PARENT_SCOPE)
endfunction()

function(check_repeatable file content)
  set(patterns ${unrepeatable})
  if(NOT file MATCHES "${clock_rooms}")
    list(APPEND patterns "${clock}")
  endif()
  foreach(pattern IN LISTS patterns)
    if(content MATCHES "${pattern}")
      crossing("${file}" "${CMAKE_MATCH_0}" "two runs or two machines could differ; see sim/geometry/portable_math.hpp")
    endif()
  endforeach()
  set(crossings ${crossings} PARENT_SCOPE)
endfunction()

set(checked 0)
foreach(room IN LISTS rooms)
  file(GLOB_RECURSE files RELATIVE "${ROOT}" "${ROOT}/${room}/*.hpp" "${ROOT}/${room}/*.h" "${ROOT}/${room}/*.cpp")
  foreach(file IN LISTS files)
    room_of("${file}" own)
    if(NOT own STREQUAL room)  # of a room within this one
      continue()
    endif()
    math(EXPR checked "${checked} + 1")
    file(READ "${ROOT}/${file}" content)
    string(REGEX REPLACE "[][;\\]" " " content "${content}")  # these have a meaning of their own in CMake's lists
    string(REGEX REPLACE "//[^\n]*" "" content "${content}")
    string(REGEX MATCHALL "#[ \t]*include[ \t]*[<\"][^>\"\n]+" includes "${content}")
    foreach(include IN LISTS includes)
      string(REGEX REPLACE "^.*[<\"]" "" header "${include}")
      check_room_include("${file}" "${room}" "${header}")
      check_library_include("${file}" "${header}")
    endforeach()
    if(file MATCHES "${repeatable}")
      check_repeatable("${file}" "\n${content}")
    endif()
  endforeach()
endforeach()

if(checked EQUAL 0)
  message(FATAL_ERROR "no sources under ${ROOT}")
elseif(crossings GREATER 0)
  message(FATAL_ERROR "${crossings} crossings")
endif()
message("${checked} files, no wall crossed")
