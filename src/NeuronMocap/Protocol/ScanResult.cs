namespace NeuronMocap.Protocol;

/// <summary>The three possible results of <see cref="PacketScanner"/>.</summary>
public enum ScanStatus
{
    /// <summary>The bytes may start a packet but are incomplete. Call again when there are <see cref="ScanResult.Length"/> bytes.</summary>
    NeedMoreData,

    /// <summary>The first <see cref="ScanResult.Length"/> bytes are one complete packet.</summary>
    Packet,

    /// <summary>The first <see cref="ScanResult.Length"/> bytes are outside packets; skip them.</summary>
    Skipped,
}

/// <summary>The reason why bytes were skipped.</summary>
public enum SkipReason
{
    /// <summary>There was no pair of tokens: the bytes are noise, the rest of a packet whose start was missed, or another protocol.</summary>
    NoTokens,

    /// <summary>A motion header has both tokens, but a data version other than 1.0 and 1.1.</summary>
    UnknownVersion,

    /// <summary>A header has both tokens, but announces more values or a larger payload than the limit allows.</summary>
    TooLarge,

    /// <summary>The start of a packet whose rest never arrived: a datagram was lost, or the connection ended.</summary>
    Incomplete,

    /// <summary>
    /// A line of the text stream lacks the values of the 59 bones, or contains a word that is not a number: protocol.md section 8.
    /// </summary>
    MalformedLine,

    /// <summary>
    /// A line of the text stream has a few more words than a frame. The avatar's name contains spaces, and numbers among its words, which look like
    /// values. Names with spaces can be read if none of their words is a number.
    /// </summary>
    AmbiguousName,

    /// <summary>Over UDP, the sender of a datagram exceeds the limit: 64 other senders already deliver frames.</summary>
    TooManySenders,

    /// <summary>Motion data arrived on the port of calculation data (CalculationPort).</summary>
    NotCalculation,

    /// <summary>
    /// A line of the text stream has as many numbers as a motion frame has values, but not the avatar's number and name before them.
    /// </summary>
    MissingAvatar,
}

/// <summary>The result of <see cref="PacketScanner"/> for the start of the given bytes.</summary>
/// <param name="Status">The kind of the result.</param>
/// <param name="Length">Number of bytes of the packet, bytes to skip, or bytes that the next call needs.</param>
/// <param name="Kind">Kind of the packet; <see cref="PacketKind.None"/> if there is no packet.</param>
/// <param name="Reason">Why the bytes are skipped; meaningful only if they are.</param>
public readonly record struct ScanResult(ScanStatus Status, int Length, PacketKind Kind = PacketKind.None, SkipReason Reason = SkipReason.NoTokens);
