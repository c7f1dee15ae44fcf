# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
#
# cmake -DOUTPUT=file.cpp -DINPUTS=a.css;b.mustache -DHEADER=h.h -DSCOPE=a::b -DTABLE=name
#   -P EmbedTable.cmake
# Writes the texts into an array of {file name, text}, terminated by a null, that HEADER
# declares in SCOPE as `extern const EmbeddedText TABLE[]`.
set(text)
foreach(input IN LISTS INPUTS)
  get_filename_component(name ${input} NAME)
  file(READ ${input} content)
  string(APPEND text "  {\"${name}\", R\"embedded(${content})embedded\"},\n")
endforeach()
file(WRITE ${OUTPUT}.new "#include \"${HEADER}\"

namespace ${SCOPE} {

const EmbeddedText ${TABLE}[] = {
${text}  {nullptr, nullptr}};

} // namespace ${SCOPE}
")
file(COPY_FILE ${OUTPUT}.new ${OUTPUT} ONLY_IF_DIFFERENT)
