namespace NeuronMocap.Calculation;

/// <summary>
/// How the text of a calculation export looks. A file that was read and is written with its own format has the same bytes, where each of its
/// rows is like the first one; else it has the same values.
/// </summary>
public sealed record CalculationTextFormat
{
    /// <summary>Most decimals that can be asked for.</summary>
    public const int MaxDecimals = 16;

    internal const int LongestSpace = 256;

    /// <summary>Axis Neuron's: four decimals, tabs, also after the last value, CR LF.</summary>
    public static CalculationTextFormat AxisNeuron { get; } = new();

    /// <summary>What stands before the first row, to its line end, byte for byte. Default: nothing.</summary>
    public ReadOnlyMemory<byte> Header { get; init; }

    /// <summary>What stands between two values: white space. Default: a tab.</summary>
    /// <exception cref="ArgumentException">It is empty, or something else.</exception>
    public string Separator
    {
        get;
        init => field = IsSpace(value) && value.Length > 0 && !HasLineEnd(value)
            ? value
            : throw new ArgumentException("The separator must be white space without a line end.", nameof(value));
    } = "\t";

    /// <summary>
    /// Fewest digits after the point, 0 to 16. A value that these cannot tell from its neighbours gets as many as are needed. The contact
    /// flags are written as 0 and 1. Default: 4.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The number is outside its range.</exception>
    public int Decimals
    {
        get;
        init => field = value is >= 0 and <= MaxDecimals
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, $"The number of decimals must be 0 to {MaxDecimals}.");
    } = 4;

    /// <summary>What follows the last value of a row: white space with a line end. Default: a tab, CR LF.</summary>
    /// <exception cref="ArgumentException">It is something else.</exception>
    public string RowEnd
    {
        get;
        init => field = IsSpace(value) && HasLineEnd(value)
            ? value
            : throw new ArgumentException("The row end must be white space and a line end.", nameof(value));
    } = "\t\r\n";

    /// <summary>What follows the last row's last value: white space, or nothing; null for the same as in all rows. Default: null.</summary>
    /// <exception cref="ArgumentException">It is something else.</exception>
    public string? LastRowEnd
    {
        get;
        init => field = value is null || IsSpace(value)
            ? value
            : throw new ArgumentException("The last row must end with white space or nothing.", nameof(value));
    }

    /// <summary>
    /// The same layout with a header that says the frame rate, in a line <c>Frame Rate:</c> below what stands there already. An export has no place for the
    /// rate; a program that does not know the line takes the file for one of 120 Hz, or for one with a header.
    /// </summary>
    /// <param name="frameRate">Frames per second, a positive number.</param>
    /// <returns>The layout.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The number is not positive, or infinite.</exception>
    public CalculationTextFormat WithFrameRate(double frameRate)
    {
        if (!(frameRate > 0) || double.IsInfinity(frameRate))
            throw new ArgumentOutOfRangeException(nameof(frameRate), frameRate, "The frame rate must be a positive number.");

        return this with { Header = CalculationHeaderText.WithFrameRate(Header.Span, frameRate) };
    }

    private static bool IsSpace(string text) =>
        text.Length <= LongestSpace && text.AsSpan().Trim(" \t\v\f\r\n").IsEmpty;

    private static bool HasLineEnd(string text) => text.AsSpan().IndexOfAny('\r', '\n') >= 0;
}
