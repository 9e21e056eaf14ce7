#!/usr/bin/env bash
# Publishes the programs that the benchmark start measures, to the folder given: a small program and the tool, compiled at run time and in advance.
set -euo pipefail
out=$(realpath -m "$1")
cd "$(dirname "$0")/../.."
runtime=$(dotnet msbuild src/NeuronMocap.Tool -getProperty:NETCoreSdkPortableRuntimeIdentifier)

publish() { dotnet publish "$1" -v quiet -p:ArtifactsPath="$out/$2.build" -p:UseArtifactsOutput=true --output "$out/$2" "${@:3}"; }

first=tests/NeuronMocap.FirstFrame
publish "$first" first-frame-jit
publish "$first" first-frame-ready -p:Runtime="$runtime" -p:Form=ready
publish "$first" first-frame-aot -p:Runtime="$runtime" -p:Form=aot
publish src/NeuronMocap.Tool tool-jit
publish src/NeuronMocap.Tool tool-ready -p:Runtime="$runtime" -p:SelfContained=false -p:PublishSingleFile=false -p:EnableCompressionInSingleFile=false \
    -p:PublishReadyToRun=true
rm -rf "$out"/*.build
