# Every flag of the compiler, in one place.
#   carrel_every_tick(target)       where a tick's time goes
#   carrel_seldom(target)           what no tick calls
#   carrel_quick_to_compile(files)  whose headers cost all the time to compile and none to run
option(CARREL_SANITIZE "Address and undefined sanitizers, the simulation's own flags unchanged" OFF)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O2")
set(CMAKE_CXX_FLAGS_DEBUG "-O0 -g")

# One instruction set for every machine and no contraction: the same inputs give the same bits everywhere.
add_compile_options(-march=x86-64-v3 -ffp-contract=off -Wall -Wextra -Wpedantic -Werror)
# What assertions say of their file is where it is in the tree; the tree's own place is in no program.
add_compile_options(-ffile-prefix-map=${PROJECT_SOURCE_DIR}/=)
if(NOT CMAKE_UNITY_BUILD)  # where files are compiled as one, a file's own name may hide that of another
  add_compile_options(-Wshadow)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # False in GCC 12 for std::string's moves, which it no longer knows for a system header's once they are precompiled.
  # The address sanitizer looks for the same.
  add_compile_options(-Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
endif()
if(NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
  add_compile_definitions(EIGEN_NO_DEBUG)  # Eigen's checks alone; our own asserts stay on
endif()
if(CARREL_SANITIZE)
  # Undefined sub-checks that cost two fifths of the build and guard what the address sanitizer sees when it is used; of
  # pointers out of line there is nothing to make one: no cast in the tree reads bytes as wider words.
  add_compile_options(-fsanitize=address,undefined
    -fno-sanitize=object-size,vptr,pointer-overflow,null,alignment -fno-sanitize-recover=all -g1)
  add_link_options(-fsanitize=address,undefined)
endif()

# Marking every temporary vector as it comes and goes makes a sanitized drill 2.5 times slower: here that one check is
# left out, all others stay.
function(carrel_every_tick name)
  target_compile_options(${name} PRIVATE -O3)  # the same bits, a tenth faster
  if(CARREL_SANITIZE)
    target_compile_options(${name} PRIVATE -fno-sanitize-address-use-after-scope)
  endif()
endfunction()

# What costs more to compile than to run: sanitized builds optimise it less.
function(carrel_seldom name)
  if(CARREL_SANITIZE)
    target_compile_options(${name} PRIVATE -O1)
  endif()
endfunction()

# Sanitized builds do not optimise these.
function(carrel_quick_to_compile)
  if(CARREL_SANITIZE)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -O0 SKIP_PRECOMPILE_HEADERS ON)
  endif()
endfunction()
