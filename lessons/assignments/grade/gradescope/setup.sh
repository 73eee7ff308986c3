#!/bin/sh
# Gradescope runs this once, with network and as root, when the autograder's image is made: installs
# what building needs, and builds the judge for any x86-64-v2 processor.
set -eu
cd "$(dirname "$0")"
chmod 700 .    # no submission reads the hidden tests, or the judge's sources
[ ! -d hidden ] || chmod 700 hidden
export DEBIAN_FRONTEND=noninteractive SCANLIT_CMAKE_FLAGS=-DSCANLIT_TESTS=OFF
scanlit/lessons/build portable scanlit
scanlit/.build/portable/lessons/studio/scanlit --version
