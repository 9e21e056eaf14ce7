#!/usr/bin/env bash
# Measures the tables of docs/internals/performance.md again: all for net8.0 and netstandard2.1; throughput and windows for netstandard2.0, on .NET and on
# Mono. Prints them, and writes every figure as JSON to a folder: the first argument, or "results". Takes about 30 minutes. During this time, the machine
# should do nothing else.
set -euo pipefail
out=$(realpath -m "${1:-results}")
cd "$(dirname "$0")"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$out"

build() { dotnet build -c Release -v quiet -p:LibraryFramework="$1" -o "$scratch/$2" "${@:3}"; }

for build in net8.0 netstandard2.1; do
    build "$build" "$build"
    for command in bvh decode avatars consumers throughput latency streams broadcast kinematics messages retarget record window; do
        dotnet "$scratch/$build/NeuronMocap.Benchmarks.dll" "$command" --json "$out/$build-$command.json"
    done
done

# Only this build takes pipes, and relays on the receive thread.
for command in pipe relay web; do
    dotnet "$scratch/net8.0/NeuronMocap.Benchmarks.dll" "$command" --json "$out/net8.0-$command.json"
done

# The Unity package takes the netstandard2.1 build.
dotnet "$scratch/netstandard2.1/NeuronMocap.Benchmarks.dll" unity --json "$out/netstandard2.1-unity.json"

build netstandard2.0 netstandard2.0
! command -v mono > /dev/null || build netstandard2.0 mono -p:TestFramework=net472
for command in throughput window; do
    dotnet "$scratch/netstandard2.0/NeuronMocap.Benchmarks.dll" "$command" --json "$out/netstandard2.0-$command.json"
    ! command -v mono > /dev/null || mono "$scratch/mono/NeuronMocap.Benchmarks.exe" "$command" --json "$out/mono-$command.json"
done
