#!/usr/bin/env bash
# Compares the C library with a C receiver that only receives. Builds both, prints the table, and writes every figure as JSON to a folder:
# the first argument, or "results". Passes further arguments to the benchmarks, such as --runs 3. Takes about seven minutes. During this
# time, the machine should do nothing else.
set -euo pipefail
out=$(realpath -m "${1:-results}")
shift || true
cd "$(dirname "$0")/../../.."
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$out"

dotnet publish src/NeuronMocap.Native -c Release -v quiet -p:NativeFolder="$scratch/library/"
cmake -S tests/native -B "$scratch/programs" -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$scratch/library" > /dev/null
cmake --build "$scratch/programs" --target bench-raw bench-library > /dev/null
dotnet run -c Release --project tests/NeuronMocap.Benchmarks -- native --programs "$scratch/programs" --json "$out/native.json" "$@"
echo
echo "The library has $(stat -Lc %s "$scratch/library/lib/libNeuronDataReader.so") bytes."
