#!/bin/sh
# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
#
# exports.sh LIBRARY.a... OBJECT.o...
#
# No file may need a symbol that another library hides: shared libraries would not link.
for file; do
  readelf -sW "$file" | awk -v file="$file" '
    NF < 8 || $5 == "LOCAL" { next }
    $7 == "UND" { print "needs", $8, file; next }
    $5 == "GLOBAL" && $6 == "HIDDEN" && file ~ /[.]a$/ { print "hides", $8, file }'
done | sort -u | awk '
  $1 == "hides" { hides[$2] = $3; hidden++ }
  $1 == "needs" && ($2 in hides) && hides[$2] != $3 {
    print hides[$2] " hides " $2 ", which " $3 " needs: declare it LINELET_PUBLIC"
    bad = 1
  }
  END {
    if (!hidden) print "no symbol is hidden: nothing was checked"
    exit bad || !hidden
  }'
