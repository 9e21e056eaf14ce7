using NeuronMocap.RabbitMq.Connecting;
using RabbitMQ.Client;

namespace NeuronMocap.RabbitMq.Publishing;

// The number of the last frame of a routing key. Two avatars with the same name share it, because every queue gets both or none.
internal sealed class FrameNumber
{
    public long Last { get; set; }
}

// What the messages of one avatar and one kind of frame have in common.
internal sealed class Route
{
    private readonly Dictionary<string, object?> _headers;

    public Route(string stage, string avatar, PacketKind kind, string key, long run, FrameNumber number)
    {
        (Avatar, Kind, Key, Number) = (avatar, kind, key, number);
        _headers = new Dictionary<string, object?>(StringComparer.Ordinal)
        {
            [MessageHeaders.Run] = run,
            [MessageHeaders.Number] = 0L,
            [MessageHeaders.Captured] = 0L,
            [MessageHeaders.Stage] = stage,
            [MessageHeaders.Avatar] = avatar,
        };
        Properties = new BasicProperties { Headers = _headers };
    }

    public string Avatar { get; }

    public PacketKind Kind { get; }

    public string Key { get; }

    public FrameNumber Number { get; }

    // The client has encoded them when publishing returns, so one object serves all messages of the route.
    public BasicProperties Properties { get; }

    public void SetHeaders(long number, long captured)
    {
        _headers[MessageHeaders.Number] = number;
        _headers[MessageHeaders.Captured] = captured;
    }
}
