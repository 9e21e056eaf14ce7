using System.Buffers.Binary;
using System.Diagnostics;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;
using NeuronMocap.Transport;

namespace NeuronMocap.Reader;

// Detects from the frames of a connection what the server sends, and describes it in words. The receive loop writes, any thread reads the description.
internal sealed class StreamRecognizer(FrameFormat format)
{
    // Stays with one sender for a second, so two senders with different streams cannot make the status flip.
    private static readonly long TakeOverAfter = Stopwatch.Frequency;

    // For each kind, the version and the first reserved field of the newest frame, which determine the format and the rotation order.
    private readonly ulong[] _keys = new ulong[(int)PacketKind.StudioCalculation + 1];
    private volatile int _recognized;
    private volatile Described? _described;
    private int _sender;
    private long _seen;

    // A new connection is established.
    public void Reset()
    {
        Array.Clear(_keys, 0, _keys.Length);
        _recognized = 0;
        _seen = 0;
    }

    // For frames only. Returns whether the frame changes the description; for all other frames this costs two comparisons.
    public bool OnFrame(in ReceivedPacket packet)
    {
        if (packet.Sender == _sender)
            _seen = packet.Timestamp;

        ReadOnlySpan<byte> header = packet.Header;
        ulong key = ((ulong)BinaryPrimitives.ReadUInt32LittleEndian(header[2..]) << 32) | BinaryPrimitives.ReadUInt32LittleEndian(header[50..]);
        return (_keys[(int)packet.Kind] != key || _recognized == 0) && Recognize(packet, key);
    }

    // The description is read often and changes rarely, so its text is made once.
    public StreamDescription Describe()
    {
        (int recognized, DiscoveredFormat discovered) = (_recognized, format.Discovered);
        Described? described = _described;
        if (described is null || described.Recognized != recognized || described.Discovered != discovered)
            _described = described = new Described(recognized, discovered, Describe(Recognized.FromNumber(recognized), discovered));

        return described.Description;
    }

    private StreamDescription Describe(Recognized stream, DiscoveredFormat discovered)
    {
        if (stream.Format == StreamFormat.Unknown)
            return default;

        string text = stream.Format switch
        {
            StreamFormat.OldHeader => "binary format with the old header",
            StreamFormat.Text => "text format",
            StreamFormat.Studio => "binary format of Axis Studio",
            _ => "binary format",
        };
        if (!stream.IsMotion)
            return new StreamDescription(stream.Format, ConnectionReason.None, $": {text}, calculation data.");

        (ConnectionReason reason, string fault) = FindFault(stream, discovered);
        return new StreamDescription(stream.Format, reason, $": {text}; {DescribeOrder(stream, discovered)}{DescribeVariant(discovered)}.{fault}");
    }

    private string DescribeOrder(Recognized stream, DiscoveredFormat discovered) => (format.OptionOrder, stream.Order, discovered.Order) switch
    {
        ({ } option, _, _) => $"rotation order {option}, as the options say",
        (_, { } order, _) => $"rotation order {order}, as the stream says",
        (_, _, { } learnt) => $"rotation order {learnt}, as {format.FormatOrigin} says",
        _ => $"rotation order {SkeletonFormat.Default.RotationOrder} assumed, the stream does not say",
    };

    // The default, that of Appendix A, needs no mention if no other value was reported.
    private string DescribeVariant(DiscoveredFormat discovered) => (format.OptionVariant, discovered.Variant) switch
    {
        (null, { } learnt) => $"; bones with {learnt}, as {format.FormatOrigin} says",
        _ => string.Empty,
    };

    // Finds a certain or possible error in how the frames are interpreted.
    private (ConnectionReason Reason, string Text) FindFault(Recognized stream, DiscoveredFormat discovered)
    {
        (RotationOrder? reported, string origin) = stream.Order is { } order ? (order, "the stream") : (discovered.Order, format.FormatOrigin);
        if (format.OptionOrder is { } option && reported is not null && reported != option)
        {
            return (
                ConnectionReason.RotationOrderMismatch,
                $" But {origin} says {reported}: one of them is wrong. Leave RotationOrder unset to use {reported}.");
        }

        if (format.OptionVariant is { } variant && discovered.Variant is { } learnt && learnt != variant)
        {
            return (
                ConnectionReason.SkeletonVariantMismatch,
                $" The options say bones with {variant}, which the reader uses, but {format.FormatOrigin} says {learnt}: one of them is wrong. Leave "
                + $"SkeletonVariant out to use {learnt}.");
        }

        return discovered.Failure is { } failure
            ? (ConnectionReason.NotDiscovered, $" The command channel (CommandPort) did not provide the missing format settings: {failure}")
            : (ConnectionReason.None, string.Empty);
    }

    private bool Recognize(in ReceivedPacket packet, ulong key)
    {
        // Any frame of the current sender, even an unchanged one, keeps other senders out.
        if (packet.Sender != _sender && packet.Timestamp - _seen < TakeOverAfter && _recognized != 0)
            return false;

        _keys[(int)packet.Kind] = key;
        _sender = packet.Sender;
        _seen = packet.Timestamp;

        // If motion and calculation data share a connection, the motion shows the settings of the server.
        bool isMotion = packet.Kind == PacketKind.Motion;
        var known = Recognized.FromNumber(_recognized);
        if (!isMotion && known.IsMotion)
            return false;

        var found = new Recognized(FormatOf(packet), isMotion, isMotion ? FrameFormat.ReadOrder(packet.Bytes) : null);
        if (found == known)
            return false;

        _recognized = found.ToNumber();
        return true;
    }

    private static StreamFormat FormatOf(in ReceivedPacket packet)
    {
        if (packet.IsText)
            return StreamFormat.Text;

        DataVersion version = DataVersion.Read(packet.Bytes[2..]);
        return packet.Kind switch
        {
            PacketKind.StudioCalculation => StreamFormat.Studio,
            PacketKind.Motion when version.Layout == HeaderLayout.Old => StreamFormat.OldHeader,
            PacketKind.Motion when version == DataVersion.Studio => StreamFormat.Studio,
            _ => StreamFormat.Binary,
        };
    }

    private sealed record Described(int Recognized, DiscoveredFormat Discovered, StreamDescription Description);

    // Fits into one integer, so readers always see a consistent value; 0 means nothing.
    private readonly record struct Recognized(StreamFormat Format, bool IsMotion, RotationOrder? Order)
    {
        public static Recognized FromNumber(int number) =>
            new((StreamFormat)(number & 0xFF), (number & 0x100) != 0, (number >> 16) is > 0 and var order ? (RotationOrder)(order - 1) : null);

        public int ToNumber() => (int)Format | (IsMotion ? 0x100 : 0) | (Order is { } order ? ((int)order + 1) << 16 : 0);
    }
}
