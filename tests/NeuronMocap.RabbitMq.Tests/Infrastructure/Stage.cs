using System.Buffers;
using System.IO.Pipelines;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.RabbitMq;

namespace NeuronMocap.RabbitMq.Tests.Infrastructure;

/// <summary>A reader with a stream that the test writes, and the publisher that it feeds.</summary>
internal sealed class Stage : IAsyncDisposable
{
    private readonly Pipe _pipe = new(new PipeOptions(pauseWriterThreshold: 0));
    private long _written;

    private Stage(RabbitMqPublisherOptions options)
    {
        Reader = new NeuronReader(_pipe.Reader.AsStream(), new NeuronReaderOptions { SilenceTimeout = Limits.Unexpected });
        Publisher = new RabbitMqPublisher(Reader, options);
    }

    public NeuronReader Reader { get; }

    public RabbitMqPublisher Publisher { get; }

    public static RabbitMqPublisherOptions Options(Broker broker, string stage, string? stream = null) => new()
    {
        Host = "127.0.0.1",
        Port = broker.Port,
        Stage = stage,
        Stream = stream,
        ConnectTimeout = Limits.Unexpected,
        CloseTimeout = Limits.Unexpected,
        Reconnect = { InitialDelay = TimeSpan.FromMilliseconds(10), MaxDelay = TimeSpan.FromMilliseconds(500) },
    };

    public static Task<Stage> StartAsync(Broker broker, string stage, string? stream = null) => StartAsync(Options(broker, stage, stream));

    public static async Task<Stage> StartAsync(RabbitMqPublisherOptions options)
    {
        var stage = new Stage(options);
        await stage.Publisher.StartAsync(TestContext.Current.CancellationToken);
        stage.Reader.Start();
        return stage;
    }

    /// <summary>Publishes motion frames to a stream with the name of the stage.</summary>
    public static async Task<Stage> RecordAsync(Broker broker, string name, int count)
    {
        Stage stage = await StartAsync(broker, name, name);
        stage.Write(Enumerable.Range(0, count).Select(static frame => TestPackets.Motion(frame)));
        await stage.ConfirmedAsync(count);
        return stage;
    }

    public void Write(params IEnumerable<byte[]> packets)
    {
        foreach (byte[] packet in packets)
        {
            _pipe.Writer.Write(packet);
            _written++;
        }

        _ = _pipe.Writer.FlushAsync().AsTask();
    }

    /// <summary>Waits until the publisher has taken every packet from the reader.</summary>
    public Task TakenAsync() => Limits.UntilAsync(() => Publisher.GetStatistics().Frames == _written);

    /// <summary>Waits until the broker has confirmed so many packets in all.</summary>
    public Task ConfirmedAsync(int count) => Limits.UntilAsync(() => Publisher.GetStatistics().Confirmed == count);

    /// <summary>Ends the stream, and waits until everything is sent.</summary>
    public async Task EndAsync()
    {
        await _pipe.Writer.CompleteAsync();
        await Reader.Completion.Soon();
        await Publisher.Completion.Soon();
    }

    public async ValueTask DisposeAsync()
    {
        await Reader.DisposeAsync();
        await Publisher.DisposeAsync();
    }
}
