#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# The runtime's system calls, by strace: while an asset loads, only for that file; afterwards memory and threads; in steps only
# waiting and waking. docs/maintainers/testing.md
#   check_syscalls.sh FOLDER ASSET     FOLDER: with liblangevin_rigid.so
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
library=$(cd "${1:?folder of the library}" && pwd)
asset=$(realpath "${2:?an asset}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"${CC:-cc}" -std=gnu99 -Wall -Wextra -Werror -O1 -I "$here/../../include" "$here/quiet_scene.c" -L "$library" -llangevin_rigid \
    -Wl,-rpath,"$library" -o "$work/quiet_scene"

# Calls of a phase, as name and arguments; for calls interrupted by another thread's, without the second half.
phase() { # its mark, the next phase's mark
    sed -e 's/^\[pid *[0-9]*\] //' -e 's/^[0-9]* *//' "$work/trace" | sed -n "/lr-mark-$1\"/,/lr-mark-$2\"/p" |
        grep -vE 'lr-mark-|^<\.\.\.|^\+\+\+|^---|^strace:' | grep -vE '^rt_sigaction\(SIGRT_[0-9]' || true # glibc's own, with its first thread
}
trace() { strace -f -qq -s 200 -o "$work/trace" "$work/quiet_scene" "$@"; }
# Permitted calls by phase.
memory='brk|mmap|munmap|mremap|mprotect|madvise'
threads='clone|clone3|set_robust_list|rseq|rt_sigprocmask|sched_getaffinity|exit|gettid|prlimit64'
waiting='futex|sched_yield|clock_nanosleep|nanosleep|restart_syscall'
others() { # mark, next mark, allowed
    phase "$1" "$2" | grep -vE "^($3)\(" || true
}
judge() {
    local bad=0 calls
    calls=$(others load scene "$memory|openat|read|close|fstat|newfstatat|lseek")
    calls+=$(phase load scene | grep -E '^openat' | grep -vF "\"$asset\", O_RDONLY" || true)
    [ -z "$calls" ] || { echo "while loading:"; echo "$calls" | head -n 5; bad=1; }
    calls=$(others scene steps "$memory|$threads|$waiting")
    [ -z "$calls" ] || { echo "while a scene is made:"; echo "$calls" | head -n 5; bad=1; }
    calls=$(others steps look "$waiting|$memory")
    [ -z "$calls" ] || { echo "in steps:"; echo "$calls" | head -n 5; bad=1; }
    calls=$(others look end "$memory|$threads|$waiting")
    [ -z "$calls" ] || { echo "afterwards:"; echo "$calls" | head -n 5; bad=1; }
    return $bad
}

trace "$asset"
for name in load scene steps look end; do grep -q "lr-mark-$name" "$work/trace" || { echo "no mark $name"; exit 1; }; done
[ "$(phase load scene | grep -cF "openat(AT_FDCWD, \"$asset\", O_RDONLY")" = 1 ] || { echo "the asset was not opened once"; exit 1; }
judge || { echo "FAILED: the runtime asks the system for more than docs/maintainers/testing.md says"; exit 1; }
echo "system calls: $(phase scene end | sed 's/(.*//' | sort | uniq -c | sort -rn | awk '{printf "%s%s %s", sep, $1, $2; sep=", "}')"

# Checks that a violation would be detected.
trace "$asset" open
if judge >/dev/null; then
    echo "FAILED: a file that is opened in the middle of a step was not seen"
    exit 1
fi
