#!/usr/bin/env bash
# Measures the tables of docs/internals/performance.md again, for net8.0 and netstandard2.1. Prints them, and writes every figure as JSON to a folder:
# the first argument, or "results". Takes about 25 minutes. During this time, the machine should do nothing else.
set -euo pipefail
out=$(realpath -m "${1:-results}")
cd "$(dirname "$0")"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$out"

for build in net8.0 netstandard2.1; do
    dotnet build -c Release -v quiet -p:LibraryFramework="$build" -o "$scratch/$build"
    for command in bvh decode avatars consumers throughput latency streams broadcast kinematics retarget record window; do
        dotnet "$scratch/$build/NeuronMocap.Benchmarks.dll" "$command" --json "$out/$build-$command.json"
    done
done

# The Unity package takes the netstandard2.1 build.
dotnet "$scratch/netstandard2.1/NeuronMocap.Benchmarks.dll" unity --json "$out/netstandard2.1-unity.json"
