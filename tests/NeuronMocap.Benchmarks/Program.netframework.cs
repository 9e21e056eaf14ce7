using NeuronMocap.Benchmarks;

return await BenchmarkCommands.Root(BenchmarkCommands.Throughput(), BenchmarkCommands.Window(), BenchmarkCommands.Flood(), BenchmarkCommands.Pace())
    .Parse(args)
    .InvokeAsync();
