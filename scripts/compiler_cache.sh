# To be sourced in the project's root: compilers' results are kept from build to build, and from clone to clone, where ccache is
# installed. LR_NO_COMPILER_CACHE=1 has everything compiled.
if [ -z "${LR_NO_COMPILER_CACHE:-}" ] && command -v ccache >/dev/null; then
    export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
    # Paths within the clone count as relative ones, debug information may name another clone, messages may be in another language.
    export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=time_macros,pch_defines,locale
    export CCACHE_MAXSIZE=${CCACHE_MAXSIZE:-4G}
fi
