# Tests: one program a room.
#   carrel_test(sim_knot_test SOURCES sim/knot/namer_test.cpp ROOMS sim_knot
#     [LIBRARIES Foo::Foo] [QUICK] [RELEASE] [COST s] [CHECK Suite.Long*])
# QUICK: costs more to compile than to run; the tests themselves are not optimised.
# RELEASE: not built with sanitizers, which would make it take hours or count what they add.
# CHECK: its tests that are too long for `make test` and that `make check` runs, as --gtest_filter takes them.
# COST: of its longest test [s] where that is much; such tests start first, so that all cores finish together.
find_package(GTest REQUIRED)
include(GoogleTest)

function(carrel_test name)
  cmake_parse_arguments(TEST "QUICK;RELEASE" "CHECK;COST" "SOURCES;ROOMS;LIBRARIES" ${ARGN})
  if(TEST_RELEASE AND CARREL_SANITIZE)
    return()
  endif()
  if(NOT TEST_COST)
    set(TEST_COST 0)
  endif()
  add_executable(${name} ${TEST_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE ${TEST_ROOMS} ${TEST_LIBRARIES} GTest::gtest_main)
  if(TEST_QUICK)
    target_compile_options(${name} PRIVATE -O0)
    carrel_precompile(${name} scenarios_drill_test <gtest/gtest.h> <nlohmann/json.hpp>)
  else()
    carrel_precompile(${name} sim_geometry_test <gtest/gtest.h> <nlohmann/json.hpp>)
  endif()
  target_compile_definitions(${name} PRIVATE
    CARREL_SOURCE="${PROJECT_SOURCE_DIR}"
    CARREL_PROGRAM="$<TARGET_FILE:carrel>")
  add_dependencies(${name} carrel)
  set(properties TIMEOUT 900 COST ${TEST_COST}
    ENVIRONMENT LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/lsan.supp:print_suppressions=0)
  set(others "")
  if(TEST_CHECK)
    gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 TEST_LIST ${name}_check TEST_FILTER ${TEST_CHECK}
      PROPERTIES LABELS check ${properties})
    set(others TEST_FILTER -${TEST_CHECK})
  endif()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 ${others} PROPERTIES LABELS ${name} ${properties})
endfunction()
