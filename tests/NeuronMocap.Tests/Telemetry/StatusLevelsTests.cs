using System.Diagnostics;
using NeuronMocap.Telemetry;

namespace NeuronMocap.Tests.Telemetry;

public sealed class StatusLevelsTests
{
    private readonly StatusLevels _levels = new();
    private readonly List<(double Seconds, ConnectionState State)> _lines = [];

    [Fact]
    public void A_long_outage_is_one_warning()
    {
        for (int attempt = 0; attempt < 100; attempt++)
        {
            Tell(attempt, ConnectionState.Connecting);
            Tell(attempt, ConnectionState.Waiting, ConnectionReason.Refused);
        }

        Tell(100, ConnectionState.Connected);
        Tell(100, ConnectionState.Receiving);
        Tell(110, ConnectionState.Waiting, ConnectionReason.Refused);
        Assert.Equal(
            [(0, ConnectionState.Waiting), (100, ConnectionState.Connected), (100, ConnectionState.Receiving), (110, ConnectionState.Waiting)],
            _lines);
    }

    [Fact]
    public void A_server_that_sends_a_frame_and_closes_does_not_fill_the_log()
    {
        for (int i = 0; i < 400; i++)
            Flap(i / 4.0);

        Assert.InRange(_lines.Count, 20, 45);
    }

    // The newest line above Debug describes the current state.
    [Fact]
    public void Repeated_outages_share_a_line()
    {
        Flap(0);
        Flap(1);
        Tell(2, ConnectionState.Connected);
        Tell(2, ConnectionState.Receiving);
        for (double seconds = 5; seconds < 100; seconds += 5)
            Tell(seconds, ConnectionState.Waiting, ConnectionReason.ClosedByPeer);

        Assert.Equal((10, ConnectionState.Waiting), _lines[^1]);
        Tell(100, ConnectionState.Connected);
        Tell(100, ConnectionState.Receiving);
        Assert.Equal((100, ConnectionState.Receiving), _lines[^1]);
        Tell(101, ConnectionState.Silent, ConnectionReason.NoData);
        Tell(102, ConnectionState.Receiving);
        Tell(103, ConnectionState.Silent, ConnectionReason.NoData);
        Assert.Equal((103, ConnectionState.Silent), _lines[^1]);
        Tell(104, ConnectionState.Receiving);
        Assert.Equal((104, ConnectionState.Receiving), _lines[^1]);
    }

    [Theory]
    [InlineData(ConnectionReason.Requested, ReaderEventLevel.Information)]
    [InlineData(ConnectionReason.ClosedByPeer, ReaderEventLevel.Information)]
    [InlineData(ConnectionReason.Reset, ReaderEventLevel.Error)]
    [InlineData(ConnectionReason.Refused, ReaderEventLevel.Error)]
    public void An_end_by_a_fault_is_an_error(ConnectionReason reason, ReaderEventLevel level) =>
        Assert.Equal(level, _levels.LevelOf(new ConnectionStatus(ConnectionState.Stopped, reason, "A message.")));

    private void Flap(double seconds)
    {
        Tell(seconds, ConnectionState.Connecting);
        Tell(seconds, ConnectionState.Connected);
        Tell(seconds, ConnectionState.Receiving);
        Tell(seconds, ConnectionState.Waiting, ConnectionReason.ClosedByPeer);
    }

    private void Tell(double seconds, ConnectionState state, ConnectionReason reason = ConnectionReason.None)
    {
        var status = new ConnectionStatus(state, reason, "A message.") { Timestamp = (long)(seconds * Stopwatch.Frequency) };
        if (_levels.LevelOf(status) > ReaderEventLevel.Debug)
            _lines.Add((seconds, state));
    }
}
