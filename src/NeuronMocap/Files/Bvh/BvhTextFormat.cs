namespace NeuronMocap.Bvh;

/// <summary>
/// How the text of a BVH file is laid out, so that a file that is read and written again looks the same. The default is what Axis Neuron writes.
/// A file that is read gives what it does at the first place where each of these shows. Immutable; thread-safe.
/// </summary>
public sealed record BvhTextFormat
{
    internal const int LongestBlanks = 16;

    /// <summary>Axis Neuron's: CR LF, four spaces, three decimals in offsets, six in rows, a space at the end of each row.</summary>
    public static BvhTextFormat AxisNeuron { get; } = new();

    /// <summary>What ends a line: CR LF, LF, or CR.</summary>
    /// <exception cref="ArgumentException">It is something else.</exception>
    public string LineEnd
    {
        get;
        init => field = value is "\r\n" or "\n" or "\r" ? value : throw new ArgumentException("The line end must be CR LF, LF or CR.", nameof(value));
    } = "\r\n";

    /// <summary>What a line is indented by for each level: at most 16 spaces or tabs, or nothing.</summary>
    /// <exception cref="ArgumentException">It is something else.</exception>
    public string Indentation
    {
        get;
        init => field = IsBlank(value) ? value : throw new ArgumentException("The indentation must be at most 16 spaces or tabs.", nameof(value));
    } = "    ";

    /// <summary>What stands between the values of a row: 1 to 16 spaces or tabs.</summary>
    /// <exception cref="ArgumentException">It is something else.</exception>
    public string Separator
    {
        get;
        init => field = value.Length > 0 && IsBlank(value) ? value : throw new ArgumentException("The separator must be 1 to 16 spaces or tabs.", nameof(value));
    } = " ";

    /// <summary>
    /// Least number of digits after the point in offsets, from 0. A writer has more where these would make it another binary32 value.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The number is below 0.</exception>
    public int OffsetDecimals
    {
        get;
        init => field = value >= 0 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "The number of decimals must not be negative.");
    } = 3;

    /// <summary>
    /// Least number of digits after the point in rows, from 0. A writer has more where these would make it another binary32 value.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The number is below 0.</exception>
    public int ValueDecimals
    {
        get;
        init => field = value >= 0 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "The number of decimals must not be negative.");
    } = 6;

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

    private static bool IsBlank(string text) => text.Length <= LongestBlanks && text.AsSpan().Trim(" \t\v\f").IsEmpty;
}
