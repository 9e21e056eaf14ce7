using NeuronMocap.Tool.Relay;
using NeuronMocap.Tool.Relay.Destinations;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Tests.Relay;

public sealed class RelayFlowTests
{
    [Fact]
    public async Task A_line_goes_on_after_the_reason_of_a_failure()
    {
        await using var reader = new NeuronReader("127.0.0.1", 1);
        await using var outlet = new FakeOutlet(new OutletFigures(5, 2) { Failure = "'a.nmrec': the disk is full." });
        string line = new RelayFlow(reader, "demo", [outlet]).ToLine(DateTime.Now);

        Assert.EndsWith("  a.nmrec: failed: 'a.nmrec': the disk is full, 0.0 pieces/s, 5 sent, 2 dropped", line, StringComparison.Ordinal);
        Assert.Equal("a.nmrec: 5 pieces, 2 dropped; failed: 'a.nmrec': the disk is full", RelayFlow.Summarize(outlet));
    }

    private sealed class FakeOutlet(OutletFigures figures) : Outlet
    {
        public override string Name => "a.nmrec";

        public override string Announcement => "Recording to a.nmrec";

        public override string Noun => "piece";

        public override OutletFigures GetFigures() => figures;

        public override Task<bool> FinishAsync(StandardStreams streams) => Task.FromResult(false);

        public override ValueTask DisposeAsync() => ValueTask.CompletedTask;
    }
}
