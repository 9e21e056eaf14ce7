namespace NeuronMocap.Protocol;

/// <summary>The three answers of <see cref="PacketScanner"/>.</summary>
public enum ScanStatus
{
    /// <summary>The bytes may start a packet, but not all of it is there: call again when <see cref="ScanResult.Length"/> bytes are.</summary>
    NeedMoreData,

    /// <summary>The first <see cref="ScanResult.Length"/> bytes are one whole packet.</summary>
    Packet,

    /// <summary>The first <see cref="ScanResult.Length"/> bytes belong to no packet: drop them and go on.</summary>
    Skipped,
}

/// <summary>Why bytes were skipped.</summary>
public enum SkipReason
{
    /// <summary>There was no pair of tokens: noise, the rest of a packet whose start was missed, or another protocol.</summary>
    NoTokens,

    /// <summary>Both tokens of a motion header, but a data version other than 1.0 and 1.1.</summary>
    UnknownVersion,

    /// <summary>Both tokens, but more values or a larger payload than the limit allows.</summary>
    TooLarge,

    /// <summary>The start of a packet whose rest never came: a lost datagram, or a connection that ended.</summary>
    Incomplete,

    /// <summary>
    /// A line of the text stream with another number of values than the 59 bones have, or with a word that is no number: protocol.md section 8.
    /// </summary>
    MalformedLine,

    /// <summary>
    /// A line of the text stream with a few words more than a frame has: the avatar's name has spaces, and numbers among its words, which cannot be
    /// told from the values. Names with spaces are read when no word of them is a number.
    /// </summary>
    AmbiguousName,

    /// <summary>Over UDP, a datagram of one sender too many: 64 others deliver frames.</summary>
    TooManySenders,

    /// <summary>Motion data on the port of calculation data (CalculationPort).</summary>
    NotCalculation,

    /// <summary>
    /// A line of the text stream with as many numbers as a motion frame has values, and without the avatar's number and name in front of them.
    /// </summary>
    MissingAvatar,
}

/// <summary>What <see cref="PacketScanner"/> found at the start of the bytes it was given.</summary>
/// <param name="Status">Which of the three answers this is.</param>
/// <param name="Length">Bytes of the packet, bytes to drop, or bytes that must be there before the next call can tell more.</param>
/// <param name="Kind">Kind of the packet; <see cref="PacketKind.None"/> unless there is one.</param>
/// <param name="Reason">Why the bytes are dropped; without meaning unless they are.</param>
public readonly record struct ScanResult(ScanStatus Status, int Length, PacketKind Kind = PacketKind.None, SkipReason Reason = SkipReason.NoTokens);
