namespace NeuronMocap.Server.Faults;

// What some senders of the text stream do differently; a reader should put up with it (protocol.md section 8).
[Flags]
internal enum TextQuirks
{
    // Nothing: motion lines end with CR LF, calculation lines with LF.
    None = 0,

    // Motion lines, too, end with LF alone.
    LineFeedOnly = 1,

    // A zero byte stands before each line.
    StrayZeros = 2,
}
