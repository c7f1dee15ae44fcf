# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
#
# cmake -DTOOL=linelet -DFOLDER=dir -P Manuals.cmake
# Has the tool write its manual pages (dir/man1) and its bash completion (dir/linelet).
# Commands left out of this build have none.
function(ask variable)
  execute_process(COMMAND ${TOOL} ${ARGN}
    OUTPUT_VARIABLE text RESULT_VARIABLE failed ERROR_QUIET)
  if(failed)
    set(text)
  endif()
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

ask(names --list-commands)
string(STRIP "${names}" names)
string(REPLACE "\n" ";" names "${names}")
ask(page --help-manual)
file(WRITE ${FOLDER}/man1/linelet.1 "${page}")
ask(completion --help-completion)
foreach(name IN LISTS names)
  string(REPLACE " " ";" words "${name}")
  string(REPLACE " " "-" file "linelet-${name}")
  ask(page ${words} --help-manual)
  if(NOT page)
    continue()
  endif()
  file(WRITE ${FOLDER}/man1/${file}.1 "${page}")
  ask(entries ${words} --help-completion)
  string(APPEND completion "${entries}")
endforeach()
file(WRITE ${FOLDER}/linelet "${completion}")
