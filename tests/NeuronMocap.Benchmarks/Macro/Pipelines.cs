using NeuronMocap.Reader;
using NeuronMocap.Skeleton;
using NeuronMocap.Telemetry;
using NeuronMocap.Transport;

namespace NeuronMocap.Benchmarks.Macro;

internal static class Pipelines
{
    // What a reader creates for itself, without a network. Handlers throw, because no frame may reach them.
    public static ReceivePipeline Create()
    {
        var status = new StatusPublisher(static _ => { });
        status.Set(new ConnectionStatus(ConnectionState.Connected, ConnectionReason.None, string.Empty));
        var activity = new LinkActivity(status, TimeSpan.FromSeconds(3), udpSenders: null);
        var pipeline = new ReceivePipeline(SkeletonFormat.Default, new StreamRecognizer(SkeletonFormat.Default), activity, status, [new SenderFilter([])], new ReaderMetrics("benchmark"), static _ => false, new ReaderRecordings(new NeuronReaderOptions(), "benchmark"), static exception => throw exception);
        pipeline.OnLinkOpened();
        return pipeline;
    }
}
