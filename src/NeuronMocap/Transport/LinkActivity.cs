using System.Diagnostics;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// Tracks what the current link delivers, and turns it into the states Receiving and Silent. The receive loop writes, a timer reads. The fields are
// independent: a check that sees an older value only reaches its conclusion one period later. isHeld: whether a playback is paused.
// explainSilence: the message for a target that has sent nothing for this time, if it is neither a TCP server nor a UDP port.
internal sealed class LinkActivity(
    StatusPublisher status,
    TimeSpan silence,
    SenderFilter? udpSenders,
    Func<StreamDescription>? describe = null,
    Func<bool>? isHeld = null,
    Func<string, TimeSpan, string>? explainSilence = null)
{
    // Limits status changes for a server that changes its format with every frame.
    private static readonly long DescriptionPeriod = Stopwatch.Frequency;

    // This many refused datagrams in one period of silence are a stream. Fewer are strays, such as those of a port scan. They are not a reason to suggest
    // that the user allow their sender.
    private const int MinRefused = 3;

    // The first bytes since the last packet that are outside packets, and the reason.
    private readonly byte[] _skipped = new byte[64];
    private volatile int _skippedLength;
    private volatile SkipReason _skipReason;
    private volatile string _target = string.Empty;
    private volatile bool _hasPackets;
    private volatile bool _hasOtherPackets; // Since the last frame.
    private volatile bool _delivering;
    private volatile int _frames;
    private int _framesSeen;
    private long _quietSince;
    private long _described;
    private volatile string? _description;

    // Timer: number of refused datagrams before the current period of silence, its start, and whether they were a stream in the previous period.
    private long _refusedBefore;
    private long _periodStart;
    private bool _isRefusing;

    // Timer: the reason that the message of the silence explains.
    private SkipReason _explained;

    public bool HasPackets => _hasPackets;

    // Any thread.
    public bool IsDelivering => _delivering;

    // Whether the stream is silent, and checks find nothing until bytes arrive.
    public bool IsIdle => status.Current is { State: ConnectionState.Silent, Reason: ConnectionReason.NoData } && _skippedLength == 0;

    // Receive loop: the first bytes outside packets have arrived, so IsIdle is false.
    public Action Disturbed { get; set; } = static () => { };

    // Receive loop, between two links.
    public void Begin(string target)
    {
        _target = target;
        _hasPackets = false;
        _hasOtherPackets = false;
        _skippedLength = 0;
        Volatile.Write(ref _quietSince, Stopwatch.GetTimestamp());
    }

    // Receive loop, around the handlers of every packet. While a handler runs, the reader is busy, and the server is not silent.
    public void BeginDelivery(in ReceivedPacket packet)
    {
        _delivering = true;
        if (!packet.IsFrame)
        {
            _hasOtherPackets = true;
            return;
        }

        _frames++;
        _skippedLength = 0;
        _hasOtherPackets = false;
        if (status.State != ConnectionState.Receiving)
            Resume(packet.Timestamp);
    }

    public void EndDelivery() => _delivering = false;

    // A separate method, because its lambdas would cause an allocation in every call of the method that contains them.
    private void Resume(long timestamp)
    {
        _hasPackets = true;
        StreamDescription stream = Describe();
        Volatile.Write(ref _described, timestamp);
        _description = stream.Text;
        status.TrySet(
            current => current.IsConnected && current.State != ConnectionState.Receiving,
            current => current with
            {
                State = ConnectionState.Receiving,
                Format = stream.Format,
                Reason = stream.Reason,
                Message = MessageOf(stream),
                Attempt = 0,
                Timestamp = timestamp,
            });
    }

    // Called by the receive loop when the stream changes, by the timer for a delayed description, and by discovery, which is not delayed.
    public void Redescribe(long timestamp, bool isDue = false)
    {
        if (status.State != ConnectionState.Receiving || (!isDue && timestamp - Volatile.Read(ref _described) < DescriptionPeriod))
            return;

        // After a jump in a playback nothing is known until the next frame, so the last description stays valid.
        StreamDescription stream = Describe();
        if (stream.Format == StreamFormat.Unknown || string.Equals(stream.Text, _description, StringComparison.Ordinal))
            return;

        _description = stream.Text;
        string message = MessageOf(stream);
        bool isSet = status.TrySet(
            current => current.State == ConnectionState.Receiving && (current.Format != stream.Format || !string.Equals(current.Message, message, StringComparison.Ordinal)),
            current => current with { Format = stream.Format, Reason = stream.Reason, Message = message, Timestamp = timestamp });
        if (isSet)
            Volatile.Write(ref _described, timestamp);
    }

    private StreamDescription Describe() => describe?.Invoke() ?? default;

    private string MessageOf(in StreamDescription stream) => $"Receiving from {_target}{stream.Text ?? "."}";

    // Receive loop, for bytes that are not packets.
    public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason)
    {
        int length = _skippedLength;

        // These reasons say more than an earlier one, such as that for the rest of a line. The first of them stays, so that the message does not alternate.
        if (length == 0 || (IsExact(reason) && !IsExact(_skipReason)))
            _skipReason = reason;

        bytes = bytes[..Math.Min(bytes.Length, _skipped.Length - length)];
        bytes.CopyTo(_skipped.AsSpan(length));
        _skippedLength = length + bytes.Length;
        if (length == 0)
            Disturbed();
    }

    // Receive loop, after the link. If a server sent something else and then closed, the reason is more than the end of the connection.
    public LinkEnd Explain(LinkEnd end) => !_hasPackets && _skippedLength > 0 && _skipReason != SkipReason.Incomplete
        && end.Reason is ConnectionReason.ClosedByPeer or ConnectionReason.Reset or ConnectionReason.EndOfRecording
        ? end with { Reason = ConnectionReason.UnknownFormat, Message = $"{ConnectionMessages.UnknownFormat(_target, DescribeSkipped())} Then the connection ended." }
        : end;

    // Timer.
    public void Check(long now)
    {
        if (status.State is not (ConnectionState.Connected or ConnectionState.Receiving or ConnectionState.Silent))
            return;

        Redescribe(now);
        int frames = _frames;
        if (_delivering || frames != _framesSeen || isHeld?.Invoke() == true)
        {
            _framesSeen = frames;
            Volatile.Write(ref _quietSince, now);
            BeginPeriod(now);
            return;
        }

        long quietSince = Volatile.Read(ref _quietSince);
        if (_periodStart < quietSince)
            BeginPeriod(quietSince);
        if (!HasEnded(quietSince, now))
            return;

        if (HasEnded(_periodStart, now))
        {
            _isRefusing = udpSenders?.RefusedDatagrams - _refusedBefore >= MinRefused;
            BeginPeriod(now);
        }

        // Every further check of a long silence comes here, so the message is made only once.
        ConnectionReason reason = FindReason();
        SkipReason skipped = reason == ConnectionReason.UnknownFormat ? _skipReason : default;
        bool isNew = skipped != _explained;
        if (status.Current is { State: ConnectionState.Silent } silent && silent.Reason == reason && !isNew)
            return;

        string message = ExplainSilence(reason);
        bool isSet = status.TrySet(
            current => current.IsConnected && (current.State != ConnectionState.Silent || current.Reason != reason || isNew),
            current => current with { State = ConnectionState.Silent, Reason = reason, Message = message, Timestamp = now });
        if (isSet)
            _explained = skipped;
    }

    private static bool IsExact(SkipReason reason) => reason is SkipReason.AmbiguousName or SkipReason.MissingAvatar;

    private bool HasEnded(long start, long now) => (now - start) / (double)Stopwatch.Frequency >= silence.TotalSeconds;

    private void BeginPeriod(long start)
    {
        _periodStart = start;
        _refusedBefore = udpSenders?.RefusedDatagrams ?? 0;
    }

    private ConnectionReason FindReason() => _skippedLength > 0 ? ConnectionReason.UnknownFormat
        : !_hasOtherPackets && udpSenders is not null && _isRefusing ? ConnectionReason.SenderNotAllowed
        : ConnectionReason.NoData;

    private string ExplainSilence(ConnectionReason reason) => (reason, udpSenders) switch
    {
        (ConnectionReason.UnknownFormat, _) => ConnectionMessages.UnknownFormat(_target, DescribeSkipped()),
        (ConnectionReason.SenderNotAllowed, { } senders) => ConnectionMessages.SenderNotAllowed(_target, senders.RefusedSenders),
        _ when isHeld is null && _hasOtherPackets => ConnectionMessages.NoValues(_target),
        (_, { } senders) => ConnectionMessages.NoDatagrams(_target, silence, senders.RefusedDatagrams),
        _ => (explainSilence ?? ConnectionMessages.NoFrames)(_target, silence),
    };

    private string DescribeSkipped() => FormatGuess.Of(_skipped.AsSpan(0, _skippedLength), _skipReason).Description;
}
