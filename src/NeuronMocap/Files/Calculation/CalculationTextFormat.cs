namespace NeuronMocap.Calculation;

/// <summary>
/// Describes the text layout of a calculation export.
/// </summary>
/// <remarks>
/// A file that is read and written again in its own layout has the same bytes if all its rows look like the first one. Otherwise it has the same
/// values.
/// </remarks>
public sealed record CalculationTextFormat
{
    /// <summary>Maximum value of <see cref="Decimals"/>.</summary>
    public const int MaxDecimals = 16;

    internal const int LongestSpace = 256;

    /// <summary>The layout of Axis Neuron: four decimals, tabs between values and after the last value, CR LF.</summary>
    public static CalculationTextFormat AxisNeuron { get; } = new();

    /// <summary>The bytes before the first row, including the line end. The default is empty.</summary>
    public ReadOnlyMemory<byte> Header { get; init; }

    /// <summary>The separator between two values: white space. The default is a tab.</summary>
    /// <exception cref="ArgumentException">The value is empty, contains a line end, or is not white space.</exception>
    public string Separator
    {
        get;
        init => field = IsSpace(value) && value.Length > 0 && !HasLineEnd(value)
            ? value
            : throw new ArgumentException("The separator must be white space without a line end.", nameof(value));
    } = "\t";

    /// <summary>
    /// Minimum number of digits after the decimal point, 0 to 16. A value that needs more digits to be distinguished from its neighbours has more.
    /// Contact flags are written as 0 and 1. The default is 4.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is out of range.</exception>
    public int Decimals
    {
        get;
        init => field = value is >= 0 and <= MaxDecimals
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, $"The number of decimals must be 0 to {MaxDecimals}.");
    } = 4;

    /// <summary>The text after the last value of a row: white space with a line end. The default is a tab and CR LF.</summary>
    /// <exception cref="ArgumentException">The value is not white space with a line end.</exception>
    public string RowEnd
    {
        get;
        init => field = IsSpace(value) && HasLineEnd(value)
            ? value
            : throw new ArgumentException("The row end must be white space and a line end.", nameof(value));
    } = "\t\r\n";

    /// <summary>
    /// The text after the last value of the last row: white space, or empty. The default is null, which uses <see cref="RowEnd"/>.
    /// </summary>
    /// <exception cref="ArgumentException">The value is not white space.</exception>
    public string? LastRowEnd
    {
        get;
        init => field = value is null || IsSpace(value)
            ? value
            : throw new ArgumentException("The last row must end with white space or nothing.", nameof(value));
    }

    /// <summary>
    /// Creates the same layout with a header that declares the frame rate, in a line <c>Frame Rate:</c> below the existing header.
    /// </summary>
    /// <remarks>
    /// The format of an export has no field for the rate. A program that does not know the line assumes 120 Hz, or a file with a header.
    /// </remarks>
    /// <param name="frameRate">Frames per second, a positive number.</param>
    /// <returns>The layout.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The value is not positive or not finite.</exception>
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
