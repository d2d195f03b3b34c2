# Sourced in the project's root by test.sh, demo.sh, scripts/verify.sh and .ci/run: runs steps, records their times and results.
# build/results has a log of each step, build/times.txt a line for each step and run:
#   date, what, cold|cached|warm, seconds, seconds of processor time, cores
jobs=$(nproc)
results=build/results
left_to_verify='long|load|scorecard|bench|corpus' # labels of tests (tests/CMakeLists.txt) that ./test.sh omits
mkdir -p "$results"

configure() { # directory, arguments of cmake; silent on success
    local dir=$1 log=$results/configure-${1##*/}.txt
    shift
    cmake -B "$dir" "$@" >"$log" 2>&1 || { cat "$log"; return 1; }
}
installed=$PWD/build/release/samples-prefix # samples and bindings are built against it, as by users
install_release() { cmake --install build/release --prefix "$installed" >/dev/null; }
configure_samples() { configure build/samples -S samples -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$installed"; }
run_ctest() { ctest --test-dir "$1" -j "$jobs" --output-on-failure --no-tests=error "${@:2}"; } # directory, arguments
skip() { # reason; ends the calling step
    echo "SKIPPED: $*"
    exit 77
}

# Sets `cpu`: processor time of all finished programs, s. Not for $(...): a subshell has no finished programs.
read_cpu() {
    local file=$results/times-$BASHPID # steps can run side by side
    times >"$file"
    cpu=$(awk 'NR == 2 { gsub("s", ""); split($1, u, "m"); split($2, s, "m"); printf "%d", 60 * (u[1] + s[1]) + u[2] + s[2] }' "$file")
    rm "$file"
}
cache_counts() { # hits and misses of the compiler cache
    { ccache --print-stats 2>/dev/null || true; } |
        awk '/^(direct|preprocessed)_cache_hit/ { hits += $2 } /^cache_miss/ { misses = $2 } END { print hits + 0, misses + 0 }'
}
# cold: built from nothing; cached: no build folder, but most objects are in the compiler cache; warm: built before.
start_clock() { # build folder
    built_before=$([ -e "$1/build.ninja" ] && echo yes || echo no)
    cache_before=$(cache_counts)
}
note_time() { # name, seconds, seconds of processor time
    local kind=cold hits misses hits_before misses_before
    read -r hits misses <<<"$(cache_counts)"
    read -r hits_before misses_before <<<"$cache_before"
    [ $((hits - hits_before)) -le $((misses - misses_before)) ] || kind=cached
    [ "$built_before" = no ] || kind=warm
    printf '%s %s %s %d %d %d\n' "$(date +%FT%T)" "$1" $kind "$2" "$3" "$jobs" >>build/times.txt
}

# Runs the function step_NAME in a subshell that ends at the first failure. Sets `outcome`: passed, failed or skipped.
run_step() { # script, name, title
    local log=$results/$1-$2.log start=$SECONDS status cpu cpu_before
    read_cpu
    cpu_before=$cpu
    printf '\n== %s (%d:%02d)\n' "$3" $((SECONDS / 60)) $((SECONDS % 60))
    set +e
    (set -e && "step_${2//-/_}") 2>&1 | tee "$log"
    status=${PIPESTATUS[0]}
    set -e
    case $status in 0) outcome=passed ;; 77) outcome=skipped ;; *) outcome=failed ;; esac
    read_cpu
    cpu=$((cpu - cpu_before))
    printf -- '-- %s: %s (%d s, %d s of processor time)\n' "$2" $outcome $((SECONDS - start)) $cpu | tee -a "$log"
    note_time "$1/$2" $((SECONDS - start)) $cpu
}
# Prints `N passed, N failed, N skipped` for tests of CTest and bindings, and for steps without tests. Fails if any failed.
closing_line() { # logs
    cat /dev/null "$@" | awk '
        /tests passed, [0-9]+ tests failed out of/ { f += $4; p += $NF - $4 }
        /^[a-z0-9]+: [0-9]+ passed, [0-9]+ failed/ { p += $2; f += $4; s += $6 }
        /^-- [a-z0-9-]+: (passed|failed|skipped) \(/ {
            if ($3 == "skipped") ++s
            else if ($3 == "passed") p += (p + f == 0)
            else f += (f == 0)
            passed += p; failed += f; skipped += s; p = f = s = 0
        }
        END { printf "%d passed, %d failed, %d skipped\n", passed, failed, skipped; exit failed > 0 }'
}
