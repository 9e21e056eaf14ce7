using System.Diagnostics;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Diagnostics;

// All data that arrives during a diagnosis. The receive loop writes. The two tasks signal that data arrived; all other members are read after the loop has
// ended.
internal sealed class StreamSample(PacketKind wanted) : IPacketReceiver
{
    // Enough to recognize a format and to quote a greeting.
    private const int KeptBytes = 256;

    // A sender can invent avatar numbers.
    private const int MaxAvatars = 1024;

    private readonly TaskCompletionSource<bool> _started = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly TaskCompletionSource<bool> _wantedFrame = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly Dictionary<(PacketKind Kind, int Sender, uint Avatar), AvatarSample> _avatars = [];
    private readonly Dictionary<SkipReason, (long Bytes, List<byte> Start)> _skipped = [];

    // Completes when the first bytes have arrived. Bytes that may begin a packet count only when the packet is complete.
    public Task Started => _started.Task;

    public Task WantedFrame => _wantedFrame.Task;

    public long StartedAt { get; private set; }

    public string FirstBytes { get; private set; } = string.Empty;

    public long Bytes { get; private set; }

    public long Packets { get; private set; }

    public long Commands { get; private set; }

    // Whether all frames arrived as text.
    public bool IsText => _avatars.Count > 0 && _avatars.Values.All(static avatar => avatar.Version == DataVersion.None);

    public long BytesSkipped => _skipped.Values.Sum(static skipped => skipped.Bytes);

    public IEnumerable<AvatarSample> Avatars => _avatars.Values.OrderBy(static avatar => avatar.Index);

    public bool Has(PacketKind kind) => _avatars.Keys.Any(key => key.Kind == kind);

    // Guesses the format of the bytes outside packets. The reason with the most bytes is decisive.
    public FormatGuess Guess() => Largest is { Value.Bytes: > 0 } largest
        ? FormatGuess.Of(largest.Value.Start.ToArray(), largest.Key)
        : FormatGuess.Of([], SkipReason.NoTokens);

    // Returns the skipped bytes as text, if they are text.
    public string? Quote() => BannerText.Of(Largest.Value.Start is { } start ? start.ToArray() : []);

    public void OnPacket(in ReceivedPacket packet)
    {
        if (!packet.IsText)
        {
            Begin(packet.Bytes);
            Bytes += packet.Length;
        }

        Packets++;
        if (packet.Kind == PacketKind.Command)
            Commands++;
        if (!packet.IsFrame)
            return;

        if (Find(packet.Kind, packet.Sender, packet.AvatarIndex) is { } avatar)
            avatar.OnFrame(packet);
        if (packet.Kind == wanted)
            _wantedFrame.TrySetResult(true);
    }

    public void OnText(ReadOnlySpan<byte> bytes, PacketKind kind)
    {
        Begin(bytes);
        Bytes += bytes.Length;
    }

    public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason)
    {
        Begin(bytes);
        Bytes += bytes.Length;
        if (!_skipped.TryGetValue(reason, out (long Bytes, List<byte> Start) skipped))
            skipped = (0, []);

        foreach (byte value in bytes[..Math.Min(bytes.Length, KeptBytes - skipped.Start.Count)])
            skipped.Start.Add(value);

        _skipped[reason] = (skipped.Bytes + bytes.Length, skipped.Start);
    }

    private KeyValuePair<SkipReason, (long Bytes, List<byte> Start)> Largest =>
        _skipped.OrderByDescending(static skipped => skipped.Value.Bytes).FirstOrDefault();

    private void Begin(ReadOnlySpan<byte> bytes)
    {
        if (_started.Task.IsCompleted)
            return;

        StartedAt = Stopwatch.GetTimestamp();
        FirstBytes = FormatGuess.ToHex(bytes);
        _started.TrySetResult(true);
    }

    private AvatarSample? Find(PacketKind kind, int sender, uint index)
    {
        if (_avatars.TryGetValue((kind, sender, index), out AvatarSample? avatar))
            return avatar;
        if (_avatars.Count >= MaxAvatars)
            return null;

        avatar = new AvatarSample(kind, sender, index);
        _avatars.Add((kind, sender, index), avatar);
        return avatar;
    }
}
