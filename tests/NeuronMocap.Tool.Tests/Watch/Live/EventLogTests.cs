using NeuronMocap.Tool.Watch.Live;

namespace NeuronMocap.Tool.Tests.Watch.Live;

public sealed class EventLogTests
{
    private readonly EventLog _log = new();

    [Fact]
    public void Equal_failures_are_one_event_with_a_count()
    {
        for (int attempt = 1; attempt <= 3; attempt++)
        {
            Add(ConnectionState.Connecting, "Connecting.", attempt);
            Add(ConnectionState.Waiting, "Refused.", attempt);
        }

        Assert.Equal(
            [("Connecting.", 1), ("Refused.", 3)],
            _log.Newest(10).Select(entry => (entry.Text, entry.Count)));
    }

    [Fact]
    public void The_newest_events_are_kept()
    {
        for (int i = 0; i < 1000; i++)
            Add(ConnectionState.Silent, $"{i}", attempt: 0);

        Assert.Equal(["998", "999"], _log.Newest(2).Select(entry => entry.Text), StringComparer.Ordinal);
        Assert.Equal(100, _log.Newest(1000).Count);
    }

    private void Add(ConnectionState state, string message, int attempt) =>
        _log.Add(DateTime.UnixEpoch, new ConnectionStatus(state, ConnectionReason.None, message) { Attempt = attempt });
}
