namespace NeuronMocap.Server;

/// <summary>What some senders of the text stream do differently; a reader should put up with it (protocol.md section 8).</summary>
[Flags]
public enum TextQuirks
{
    /// <summary>Nothing: motion lines end with CR LF, calculation lines with LF.</summary>
    None = 0,

    /// <summary>Motion lines, too, end with LF alone.</summary>
    LineFeedOnly = 1,

    /// <summary>A zero byte stands before each line.</summary>
    StrayZeros = 2,
}
