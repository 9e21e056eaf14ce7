#!/usr/bin/env bash
# Measures the tables of docs/internals/performance.md, and the curves beside it.
#   measure.sh [FOLDER]            all of them, in about three hours. Prints them, and writes every figure as JSON to the folder, by default "results". During
#                                  this time, the machine should do nothing else.
#   measure.sh --only NAMES …      only these, such as --only "throughput udp".
#   measure.sh --update …          then writes the tables into the page. A table that was not measured stays as it is.
#   measure.sh --smoke …           short runs that only show whether everything works; their figures mean nothing. Not with --update.
#   measure.sh --check             compares a few ratios of processor time with the page's, in seconds. Fails if one is three times as large.
set -euo pipefail
folder=results only= update= smoke= check=
while [ $# -gt 0 ]; do
    case $1 in
        --only) only=" $2 "; shift ;;
        --update) update=1 ;;
        --smoke) smoke=1 ;;
        --check) check=1 ;;
        -*) echo "Unknown option $1." >&2; exit 2 ;;
        *) folder=$1 ;;
    esac
    shift
done
[ -z "$smoke$update" ] || [ -z "$smoke" ] || [ -z "$update" ] || { echo "The figures of --smoke mean nothing, so --update refuses them." >&2; exit 2; }

out=$(realpath -m "$folder")
cd "$(dirname "$0")"
page=$(realpath ../../docs/internals/performance.md)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

build() { [ -d "$scratch/$2" ] || dotnet build -v quiet -p:LibraryFramework="$1" -o "$scratch/$2" "${@:3}" > "$scratch/log" || { cat "$scratch/log"; exit 1; }; }

if [ -n "$check" ]; then
    build net8.0 net8.0
    dotnet "$scratch/net8.0/NeuronMocap.Benchmarks.dll" check --page "$page"
    exit
fi

mkdir -p "$out"
wanted() { [ -z "$only" ] || [[ $only == *" $1 "* ]]; }

# short COMMAND: the options of a smoke run.
short() {
    case $1 in
        throughput | pipe) echo "--runs 1 --frames 20000 --writes 32" ;;
        latency | relay | native) echo "--runs 1 --rates 120 --seconds 1" ;;
        streams) echo "--runs 1 --counts 10 --seconds 1" ;;
        broadcast) echo "--runs 1 --clients 2 --seconds 1" ;;
        window | web) echo "--runs 1 --seconds 1" ;;
        bvh) echo "--runs 1 --megabytes 10" ;;
        playback) echo "--runs 1 --seconds 2" ;;
        udp) echo "--runs 1 --frames 20000" ;;
        idle) echo "--runs 1 --counts 1 --settle 1 --seconds 2" ;;
        growth) echo "--runs 1 --counts 1 10 --hours 0.1 0.2 --seconds 1" ;;
        peers) echo "--runs 1 --frames 20000 --writes 32 --rates 120 --seconds 1" ;;
        *) echo "--runs 1" ;;
    esac
}

# full COMMAND: the options of a full run. The rate of the system's own copy varies by a factor of two, so the medians of "throughput" and "broadcast" need
# more runs. The BinaryReader of "peers" needs minutes for more cases.
full() {
    case $1 in
        throughput) echo "--runs 15" ;;
        broadcast) echo "--runs 11 --seconds 3" ;;
        peers) echo "--runs 5 --writes 1 32 --rates 60 120" ;;
        growth) echo "--runs 5" ;;
    esac
}

# measure BUILD COMMAND OPTIONS...: one table.
measure() {
    wanted "$2" || return 0
    [[ $1 = mono || $1 = netstandard2.0 ]] || build "$1" "$1"
    local run=(dotnet "$scratch/$1/NeuronMocap.Benchmarks.dll")
    [ "$1" != mono ] || run=(mono "$scratch/mono/NeuronMocap.Benchmarks.exe")
    # shellcheck disable=SC2046
    "${run[@]}" "$2" $(if [ -z "$smoke" ]; then full "$2"; else short "$2"; fi) --json "$out/$1-$2.json" "${@:3}"
}

for framework in net8.0 netstandard2.1; do
    for command in bvh decode avatars consumers throughput latency streams kinematics messages retarget record window playback; do
        measure "$framework" "$command"
    done
done

# Only this build takes pipes, and relays and serves without further threads.
for command in broadcast pipe relay web udp idle check; do
    measure net8.0 "$command"
done

if wanted growth; then
    dotnet build -v quiet -o "$scratch/tool" ../../src/NeuronMocap.Tool > "$scratch/log" || { cat "$scratch/log"; exit 1; }
    measure net8.0 growth --tool "$scratch/tool/neuron-mocap.dll"
fi

# The Unity package takes the netstandard2.1 build.
measure netstandard2.1 unity

if wanted start; then
    bash publish-starts.sh "$scratch/starts"
    measure net8.0 start --programs "$scratch/starts"
fi

if wanted peers && command -v cc > /dev/null; then
    cc -O2 -std=c99 -D_GNU_SOURCE -o "$scratch/bench-raw" ../native/bench/receiver.c ../native/bench/raw.c
    measure net8.0 peers --raw "$scratch/bench-raw"
fi

if wanted native && command -v cmake > /dev/null; then
    # shellcheck disable=SC2046
    bash ../native/bench/measure.sh "$out" $([ -z "$smoke" ] || short native)
    mv "$out/native.json" "$out/net8.0-native.json"
fi

if wanted throughput || wanted window; then
    build netstandard2.0 netstandard2.0
    ! command -v mono > /dev/null || build netstandard2.0 mono -p:TestFramework=net472
    for command in throughput window; do
        measure netstandard2.0 "$command"
        ! command -v mono > /dev/null || measure mono "$command"
    done
fi

[ -z "$update" ] || build net8.0 net8.0
[ -z "$update" ] || dotnet "$scratch/net8.0/NeuronMocap.Benchmarks.dll" page --results "$out" --page "$page"
