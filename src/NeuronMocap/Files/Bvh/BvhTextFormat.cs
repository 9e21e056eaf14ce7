namespace NeuronMocap.Bvh;

/// <summary>
/// Describes the text layout of a BVH file. A file that is read and written again keeps its layout. Immutable; thread-safe.
/// </summary>
/// <remarks>
/// The default is the layout of Axis Neuron. When a file is read, each property comes from its first occurrence.
/// </remarks>
public sealed record BvhTextFormat
{
    internal const int LongestBlanks = 16;

    /// <summary>
    /// The layout of Axis Neuron: CR LF, four spaces, three decimals in offsets, six in rows, and a space at the end of each row.
    /// </summary>
    public static BvhTextFormat AxisNeuron { get; } = new();

    /// <summary>The line end: CR LF, LF, or CR.</summary>
    /// <exception cref="ArgumentException">The value is not a line end.</exception>
    public string LineEnd
    {
        get;
        init => field = value is "\r\n" or "\n" or "\r" ? value : throw new ArgumentException("The line end must be CR LF, LF or CR.", nameof(value));
    } = "\r\n";

    /// <summary>The indentation of each level: at most 16 spaces or tabs, or empty.</summary>
    /// <exception cref="ArgumentException">The value is not a valid indentation.</exception>
    public string Indentation
    {
        get;
        init => field = IsBlank(value) ? value : throw new ArgumentException("The indentation must be at most 16 spaces or tabs.", nameof(value));
    } = "    ";

    /// <summary>The separator between the values of a row: 1 to 16 spaces or tabs.</summary>
    /// <exception cref="ArgumentException">The value is not a valid separator.</exception>
    public string Separator
    {
        get;
        init => field = value.Length > 0 && IsBlank(value) ? value : throw new ArgumentException("The separator must be 1 to 16 spaces or tabs.", nameof(value));
    } = " ";

    /// <summary>
    /// Minimum number of decimals in offsets, from 0. A writer uses more where fewer would give another binary32 value.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative.</exception>
    public int OffsetDecimals
    {
        get;
        init => field = value >= 0 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "The number of decimals must not be negative.");
    } = 3;

    /// <summary>
    /// Minimum number of decimals in rows, from 0. A writer uses more where fewer would give another binary32 value.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative.</exception>
    public int ValueDecimals
    {
        get;
        init => field = value >= 0 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "The number of decimals must not be negative.");
    } = 6;

    /// <summary>Whether <see cref="Separator"/> also follows the last value of a row.</summary>
    public bool HasSeparatorAtRowEnd { get; init; } = true;

    /// <summary>Whether a blank line follows MOTION.</summary>
    public bool HasBlankLineAfterMotion { get; init; } = true;

    /// <summary>Whether the file begins with a byte order mark.</summary>
    public bool HasByteOrderMark { get; init; }

    /// <summary>
    /// The text of the frame time, such as 0.008. It is written only if <see cref="BvhFrameTime.TryParse"/> reads the file's frame time from it.
    /// Otherwise, or if this is null, <see cref="BvhFrameTime.ToString"/> is written. A <see cref="BvhWriter"/> also does so if
    /// <see cref="BvhWriter.FrameTime"/> changes and the place in the file is too short for this text.
    /// </summary>
    public string? FrameTimeText { get; init; }

    private static bool IsBlank(string text) => text.Length <= LongestBlanks && text.AsSpan().Trim(" \t\v\f").IsEmpty;
}
