#!/bin/sh
# SPDX-FileCopyrightText: 2026 the linelet authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what is needed to build and test linelet on Debian 12.
set -e
packages=$(cat "$(dirname "$0")/debian-packages.txt")
root=
[ "$(id -u)" = 0 ] || root=sudo
$root apt-get update -q
# shellcheck disable=SC2086
DEBIAN_FRONTEND=noninteractive $root apt-get install -q -y --no-install-recommends $packages
