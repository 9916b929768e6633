#!/bin/sh
# tools/compile.sh COMPILER ARGS: compiles, through ccache where it is installed. The build calls it, so that the command
# lines, and with them what must be compiled again, are the same with and without ccache.
# What one checkout compiled serves any other, in whatever folder. Precompiled headers need the sloppiness.
command -v ccache >/dev/null || exec "$@"
export CCACHE_BASEDIR="${0%/tools/compile.sh}" CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1 CCACHE_SLOPPINESS=pch_defines,time_macros
exec ccache "$@"
