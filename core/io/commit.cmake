# Writes OUTPUT, a source file with the commit of the tree SOURCE: its short hash, followed by "-dirty" if files differ
# from the commit, or "unknown" if SOURCE is not the top of a git checkout. The file is rewritten only if it changes.
# Usage: cmake -DSOURCE=... -DOUTPUT=... -P commit.cmake
cmake_minimum_required(VERSION 3.25)
set(commit unknown)
find_program(GIT git)

function(ask_git answer)
  execute_process(COMMAND ${GIT} --no-optional-locks -C ${SOURCE} ${ARGN}
                  RESULT_VARIABLE failed OUTPUT_VARIABLE text ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(failed)
    set(text)
  endif()
  set(${answer} "${text}" PARENT_SCOPE)
endfunction()

if(GIT)
  ask_git(below rev-parse --show-prefix) # in a folder of another repository, its commit is irrelevant
  ask_git(hash rev-parse --short HEAD)
  if(hash AND NOT below)
    set(commit ${hash})
    ask_git(changed status --porcelain --untracked-files=no)
    ask_git(added status --porcelain --untracked-files=all -- apps core materials nonlocal shapefunctions transfers)
    if(changed OR added)
      string(APPEND commit -dirty)
    endif()
  endif()
endif()

file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#include \"core/io/commit.hpp\"

namespace riedel {
const char* commit() { return \"@commit@\"; }
} // namespace riedel
" @ONLY)
