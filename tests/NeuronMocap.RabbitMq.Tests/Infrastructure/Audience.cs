using NeuronMocap.Tests.RabbitMq;

namespace NeuronMocap.RabbitMq.Tests.Infrastructure;

/// <summary>A source, the reader that uses it, and the packets that arrive.</summary>
internal sealed class Audience : IAsyncDisposable
{
    private readonly List<byte[]> _packets = [];
    private readonly ManualResetEventSlim _isOpen = new(initialState: true);

    private Audience(RabbitMqSourceOptions options, TimeSpan? restTime)
    {
        Source = new RabbitMqSource(options) { RestTime = restTime };
        Reader = new NeuronReader(new NeuronReaderOptions
        {
            Source = Source,
            SilenceTimeout = Limits.Unexpected,
            Reconnect = { InitialDelay = TimeSpan.FromMilliseconds(10), MaxDelay = TimeSpan.FromMilliseconds(500) },
        });
        Reader.MotionReceived += Take;
        Reader.CalculationReceived += Take;
        Reader.StudioCalculationReceived += Take;
    }

    public RabbitMqSource Source { get; }

    public NeuronReader Reader { get; }

    public byte[][] Packets
    {
        get
        {
            lock (_packets)
                return [.. _packets];
        }
    }

    public uint[] FrameIndices => [.. Packets.Select(static packet => MotionHeader.TryRead(packet, out MotionHeader header) ? header.FrameIndex!.Value : 0)];

    public uint? LastFrameIndex
    {
        get
        {
            lock (_packets)
                return _packets.Count > 0 && MotionHeader.TryRead(_packets[^1], out MotionHeader header) ? header.FrameIndex : null;
        }
    }

    public static RabbitMqSourceOptions Options(Broker broker, string stage, string? stream = null) => new()
    {
        Host = "127.0.0.1",
        Port = broker.Port,
        Stage = stage,
        Stream = stream,
        ConnectTimeout = Limits.Unexpected,
    };

    /// <summary>Starts to receive. What is published afterwards arrives.</summary>
    public static async Task<Audience> StartAsync(RabbitMqSourceOptions options, TimeSpan? restTime = null)
    {
        var audience = new Audience(options, restTime);
        audience.Reader.Start();
        await Limits.UntilAsync(() => audience.Source.GetStatistics().Connections > 0);
        return audience;
    }

    public static Task<Audience> StartAsync(Broker broker, string stage) => StartAsync(Options(broker, stage));

    /// <summary>Makes the handlers wait, as those of a slow program.</summary>
    public void Hold() => _isOpen.Reset();

    public void Resume() => _isOpen.Set();

    public Task UntilAsync(int count) => Limits.UntilAsync(() =>
    {
        lock (_packets)
            return _packets.Count >= count;
    });

    public async ValueTask DisposeAsync()
    {
        Resume();
        await Reader.DisposeAsync();
        _isOpen.Dispose();
    }

    private void Take(AvatarFrame frame)
    {
        _isOpen.Wait(Limits.Unexpected);
        lock (_packets)
            _packets.Add(frame.Packet.ToArray());
    }
}
