using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>Publishes what a reader receives, at once, on the thread that receives it. Ends when the reader does.</summary>
/// <remarks>
/// It sees the bytes before the reader parses them, so nothing of a packet changes. The receive thread waits only for the locks of the logs. Its own
/// thread only waits for the end.
/// </remarks>
internal sealed class ReaderPacer : Pacer, IStreamListener
{
    private readonly NeuronReader _reader;
    private readonly (UnitContent Content, FrameLog Log)[] _streams;
    private readonly FaultReport _report;
    private readonly UnitParser _parser;
    private byte[] _bytes = [];
    private SocketAddress? _sender;

    /// <summary>Creates a pacer.</summary>
    /// <param name="reader">The reader, whose owner starts and disposes it.</param>
    /// <param name="streams">What to publish, and the logs to publish to.</param>
    /// <param name="ended">See the base class.</param>
    /// <param name="report">Receives unexpected exceptions, which must not end the receive thread.</param>
    public ReaderPacer(NeuronReader reader, (UnitContent Content, FrameLog Log)[] streams, Action<Exception?> ended, FaultReport report)
        : base(ended, report)
    {
        (_reader, _streams, _report) = (reader, streams, report);
        _parser = new UnitParser(reader.MaxValues, keepsIncomplete: false);
    }

    // Thread-safe.
    public long IncompletePackets => _parser.IncompletePackets;

    public override void Open() => _reader.Tap.Add(this, Stopwatch.GetTimestamp());

    public override void Stop()
    {
        _reader.Tap.Remove(this);
        base.Stop();
    }

    protected override void PublishAll()
    {
        using var isOver = new CancellationTokenSource();
        _ = _reader.Completion.ContinueWith(_ => Stop(), isOver.Token, TaskContinuationOptions.ExecuteSynchronously, TaskScheduler.Default);
        lock (Lock)
        {
            while (!IsStopping)
                Monitor.Wait(Lock);
        }

        // The reader may live longer and must not keep this object.
        isOver.Cancel();
    }

    void IStreamListener.OnOpened(StreamConnection connection, bool wasOpen, long timestamp) =>
        Publish(Describe(RecordedEventKind.Opened, connection, timestamp) with { WasOpen = wasOpen });

    void IStreamListener.OnBytes(StreamConnection connection, int number, byte[] sender, ReadOnlySpan<byte> bytes, long timestamp)
    {
        if (_bytes.Length < bytes.Length)
            _bytes = new byte[bytes.Length];

        bytes.CopyTo(_bytes);
        Publish(Describe(RecordedEventKind.Bytes, connection, timestamp) with
        {
            Bytes = new ArraySegment<byte>(_bytes, 0, bytes.Length),
            Sender = connection.IsDatagrams ? FindSender(sender) : null,
        });
    }

    void IStreamListener.OnClosed(StreamConnection connection, string reason, long timestamp) =>
        Publish(Describe(RecordedEventKind.Closed, connection, timestamp));

    private static RecordedEvent Describe(RecordedEventKind kind, StreamConnection connection, long timestamp) =>
        new(kind, TimeSpan.FromSeconds(timestamp / (double)Stopwatch.Frequency))
        {
            Transport = connection.IsDatagrams ? TransportKind.Udp : TransportKind.Tcp,
            Connection = connection.Number,
            IsCalculation = connection.IsCalculation,
        };

    // The parser copies the address of a sender that it keeps.
    private SocketAddress FindSender(byte[] sender)
    {
        if (_sender?.Size != sender.Length)
            _sender = new SocketAddress(AddressFamily.InterNetwork, sender.Length);

        for (int i = 0; i < sender.Length; i++)
            _sender[i] = sender[i];

        return _sender;
    }

    private void Publish(in RecordedEvent received)
    {
        try
        {
            _parser.Follow(received);
            foreach ((_, FrameLog log) in _streams)
                log.Hold();

            try
            {
                PublishUnits();
            }
            finally
            {
                foreach ((_, FrameLog log) in _streams)
                    log.Release();
            }
        }
        catch (Exception exception)
        {
            // The system is out of memory. The reader goes on, and so does the relay, with the next packet.
            _report.Report(exception);
        }
    }

    private void PublishUnits()
    {
        while (_parser.TryTake(out ReadOnlySpan<byte> unit, out _, out bool isCalculation))
        {
            foreach ((UnitContent content, FrameLog log) in _streams)
            {
                if (content.Takes(isCalculation))
                    log.Publish(unit);
            }
        }
    }
}
