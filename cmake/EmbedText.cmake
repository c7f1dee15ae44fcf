# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
#
# cmake -DNAME=sources -DOUTPUT=file.cpp -DINPUTS=a.cl;b.cl -P EmbedText.cmake
# Concatenates the OpenCL sources into one string of that name.
set(text)
foreach(input IN LISTS INPUTS)
  file(READ ${input} content)
  string(APPEND text "R\"kernel(${content})kernel\"\n")
endforeach()
file(WRITE ${OUTPUT}.new "#include \"kernel_sources.h\"

namespace linelet::opencl {

const char* const ${NAME} =
${text};

} // namespace linelet::opencl
")
file(COPY_FILE ${OUTPUT}.new ${OUTPUT} ONLY_IF_DIFFERENT)
