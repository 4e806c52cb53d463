# Writes which commit is built, where that has changed: one small file, so that a commit compiles nothing else.
#   cmake -DSOURCE=tree -DOUT=commit.cpp -P commit.cmake
set(commit unknown)
if(EXISTS "${SOURCE}/.git")
  execute_process(COMMAND git -C "${SOURCE}" describe --always --dirty=+ --abbrev=7 --exclude=*
    OUTPUT_VARIABLE said OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(failed EQUAL 0)
    set(commit "${said}")
  endif()
endif()
file(CONFIGURE OUTPUT "${OUT}" CONTENT
"#include \"app/build_info.hpp\"

const char* const app::commit = \"@commit@\";
" @ONLY)
