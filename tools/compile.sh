#!/bin/sh
# tools/compile.sh COMPILER ARGS: compiles, through ccache where it is installed. The build calls it, so that the command
# lines, and with them what must be compiled again, are the same with and without ccache.
# Precompiled headers need the sloppiness; the modification times of the headers behind them are compared anyway.
command -v ccache >/dev/null || exec "$@"
export CCACHE_DEPEND=1 CCACHE_SLOPPINESS=pch_defines,time_macros
exec ccache "$@"
