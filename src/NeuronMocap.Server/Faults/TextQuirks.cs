namespace NeuronMocap.Server.Faults;

// Deviations of some senders of the text stream, which a reader should tolerate (protocol.md section 8).
[Flags]
internal enum TextQuirks
{
    // No deviation: motion lines end with CR LF, calculation lines with LF.
    None = 0,

    // Motion lines also end with LF alone.
    LineFeedOnly = 1,

    // A zero byte precedes each line.
    StrayZeros = 2,
}
