namespace NeuronMocap.Bvh;

/// <summary>
/// How the text of a BVH file is laid out, so that a file that is read and written again looks the same. The default is what Axis Neuron writes.
/// A file that is read gives what it does at the first place where each of these shows. Immutable; thread-safe.
/// </summary>
public sealed record BvhTextFormat
{
    /// <summary>Axis Neuron's: CR LF, four spaces, three decimals in offsets, six in rows, a space at the end of each row.</summary>
    public static BvhTextFormat AxisNeuron { get; } = new();

    /// <summary>What ends a line: CR LF, LF, or CR.</summary>
    public string LineEnd { get; init; } = "\r\n";

    /// <summary>What a line is indented by for each level: spaces or tabs, or nothing.</summary>
    public string Indentation { get; init; } = "    ";

    /// <summary>What stands between the values of a row: spaces or tabs.</summary>
    public string Separator { get; init; } = " ";

    /// <summary>
    /// Least number of digits after the point in offsets, from 0. A writer has more where these would make it another binary32 value.
    /// </summary>
    public int OffsetDecimals { get; init; } = 3;

    /// <summary>
    /// Least number of digits after the point in rows, from 0. A writer has more where these would make it another binary32 value.
    /// </summary>
    public int ValueDecimals { get; init; } = 6;

    /// <summary>Whether <see cref="Separator"/> also stands after the last value of a row.</summary>
    public bool HasSeparatorAtRowEnd { get; init; } = true;

    /// <summary>Whether a blank line comes after MOTION.</summary>
    public bool HasBlankLineAfterMotion { get; init; } = true;

    /// <summary>Whether the file begins with a byte order mark.</summary>
    public bool HasByteOrderMark { get; init; }

    /// <summary>
    /// The text of the frame time, such as 0.008. It is to be written only where <see cref="BvhFrameTime.TryParse"/> makes the time of it that is
    /// to be written; elsewhere, and where this is null, <see cref="BvhFrameTime.ToString"/>.
    /// </summary>
    public string? FrameTimeText { get; init; }
}
