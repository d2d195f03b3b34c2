# Sourced in the project's root: uses ccache, if installed, across builds and clones. LR_NO_COMPILER_CACHE=1 turns it off.
if [ -z "${LR_NO_COMPILER_CACHE:-}" ] && command -v ccache >/dev/null; then
    export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
    # Paths within the clone count as relative, so debug information can name another clone; messages can be in another language.
    export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=time_macros,pch_defines,locale
    export CCACHE_MAXSIZE=${CCACHE_MAXSIZE:-4G}
fi
