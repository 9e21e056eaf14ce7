using System.Numerics;
using NeuronMocap.Files;

namespace NeuronMocap.Calculation;

/// <summary>
/// Represents a calculation export, the .calc file of Axis Neuron: rows of text with the values of calculation frames. Immutable; thread-safe.
/// </summary>
/// <remarks>
/// <para>
/// The values have the order of the calculation stream (manual, Appendix C; docs/guide/calculation.md lists the columns). Each value is the
/// binary32 number nearest to its text, including negative zero; NaN and infinity are kept.
/// </para>
/// <para>
/// Reading is lenient. A defect with one sensible interpretation is read that way and listed in <see cref="Repairs"/>. The text above the first row
/// is a header, which <see cref="TextFormat"/> keeps. Values are separated by any white space, which may also follow the last value. Blank lines
/// and the kind of line ends have no meaning. A row that lacks values is skipped, such as the last row of a truncated file.
/// </para>
/// </remarks>
public sealed class CalculationDocument
{
    /// <summary>Maximum number of entries in <see cref="Repairs"/>.</summary>
    public const int MaxListedRepairs = 100;

    private readonly List<float[]> _rows = [];
    private readonly CalculationHeader _header;

    private CalculationDocument(CalculationFileReader reader)
    {
        ValueCount = reader.ValueCount;
        float[] row = new float[ValueCount];
        while (reader.TryReadFrame(row))
        {
            _rows.Add(row);
            row = new float[ValueCount];
        }

        if (_rows.Count == 0)
            throw new CalculationFormatException("The file ends within its only row.", 1, 1);

        FrameRate = reader.FrameRate;
        DeclaredFrameRate = reader.DeclaredFrameRate;
        InitialDirection = reader.InitialDirection;
        TextFormat = reader.TextFormat;
        Repairs = reader.Repairs;
        RepairCount = reader.RepairCount;
        SkippedRowCount = reader.SkippedRowCount;
        _header = new CalculationHeader
        {
            AvatarIndex = reader.Options.AvatarIndex,
            AvatarName = new AvatarName(reader.Options.AvatarName),
        };
    }

    /// <summary>Number of rows, at least 1.</summary>
    public int FrameCount => _rows.Count;

    /// <summary>Number of values in each row: 946 for 59 bones, or 338 for 21.</summary>
    public int ValueCount { get; }

    /// <summary>Frames per second: the rate of the options, or <see cref="DeclaredFrameRate"/>, or 120.</summary>
    public double FrameRate { get; }

    /// <summary>
    /// Frames per second as declared in the header; null if not declared. Exports of this library declare the rate, those of Axis Neuron do not.
    /// </summary>
    public double? DeclaredFrameRate { get; }

    /// <summary>
    /// The direction that the actor faces at the start, in the axes of the file: the line <c>Zd:</c> of the header. Null if the header does not
    /// have this line.
    /// </summary>
    public Vector3? InitialDirection { get; }

    /// <summary>The text layout of the file.</summary>
    public CalculationTextFormat TextFormat { get; }

    /// <summary>The first hundred defects of the file, and how each was read.</summary>
    public IReadOnlyList<CalculationRepair> Repairs { get; }

    /// <summary>Number of repairs, including those that <see cref="Repairs"/> does not list.</summary>
    public int RepairCount { get; }

    /// <summary>Number of lines that were skipped because they are not rows.</summary>
    public int SkippedRowCount { get; }

    /// <summary>
    /// Reads a file into memory, 4 bytes for each value. <see cref="CalculationFileReader"/> reads a file of any length row by row.
    /// </summary>
    /// <param name="path">The path of the file.</param>
    /// <param name="options">The options; null for the defaults.</param>
    /// <returns>The document.</returns>
    /// <exception cref="CalculationFormatException">
    /// The file has no row of 946 or 338 numbers. With <see cref="CalculationReadOptions.Strict"/>: the file has a defect.
    /// </exception>
    /// <exception cref="IOException">The file does not exist or cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to read the file.</exception>
    public static CalculationDocument Load(string path, CalculationReadOptions? options = null)
    {
        using FileStream stream = CalculationFileReader.OpenFile(path);
        return Load(stream, options);
    }

    /// <summary>Reads a stream to its end.</summary>
    /// <param name="stream">The stream to read, which may deliver pieces of any size. It stays open.</param>
    /// <param name="options">The options; null for the defaults.</param>
    /// <returns>The document.</returns>
    /// <exception cref="CalculationFormatException">
    /// The text has no row of 946 or 338 numbers. With <see cref="CalculationReadOptions.Strict"/>: the text has a defect.
    /// </exception>
    /// <exception cref="IOException">The stream fails.</exception>
    public static CalculationDocument Load(Stream stream, CalculationReadOptions? options = null)
    {
        using var reader = new CalculationFileReader(stream, options, leaveOpen: true);
        return new CalculationDocument(reader);
    }

    /// <summary>Reads text.</summary>
    /// <param name="utf8">ASCII or UTF-8.</param>
    /// <param name="options">The options; null for the defaults.</param>
    /// <returns>The document, which does not keep a reference to the text.</returns>
    /// <exception cref="CalculationFormatException">
    /// The text has no row of 946 or 338 numbers. With <see cref="CalculationReadOptions.Strict"/>: the text has a defect.
    /// </exception>
    public static CalculationDocument Parse(ReadOnlySpan<byte> utf8, CalculationReadOptions? options = null)
    {
        using var text = new MemoryStream(utf8.ToArray(), writable: false);
        return Load(text, options);
    }

    /// <summary>Gets the values of a frame, in the order of the calculation stream.</summary>
    /// <param name="index">Number of the frame, from 0.</param>
    /// <returns><see cref="ValueCount"/> values, in the document's own memory.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The frame does not exist.</exception>
    public ReadOnlySpan<float> GetValues(int index)
    {
        if ((uint)index >= (uint)FrameCount)
            throw new ArgumentOutOfRangeException(nameof(index), index, $"The index must be at least 0 and less than the number of frames, {FrameCount}.");

        return _rows[index];
    }

    /// <summary>
    /// Creates a frame like one from a stream with the same values. Its <see cref="AvatarFrame.FrameIndex"/> is its number in the file.
    /// </summary>
    /// <param name="index">Number of the frame, from 0.</param>
    /// <returns>A new frame on every call, which owns its memory.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The frame does not exist.</exception>
    public CalculationFrame GetFrame(int index)
    {
        ReadOnlySpan<float> values = GetValues(index);
        return new CalculationFrame(_header with { FrameIndex = (uint)index }, values);
    }

    /// <summary>Gets which feet touch the ground in a frame.</summary>
    /// <param name="index">Number of the frame, from 0.</param>
    /// <returns>The foot contacts of the frame.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The frame does not exist.</exception>
    public FootContacts GetFootContacts(int index)
    {
        ReadOnlySpan<float> flags = GetValues(index)[(CalculationFrame.BodyValueCount - 2)..];
        return new FootContacts(flags[0] != 0, flags[1] != 0);
    }

    /// <summary>Writes the document to a file.</summary>
    /// <param name="path">The path of the file. An existing file is replaced.</param>
    /// <param name="format">The text layout; null for <see cref="TextFormat"/>, the layout that was read.</param>
    /// <exception cref="IOException">The file cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to write the file.</exception>
    public void Save(string path, CalculationTextFormat? format = null)
    {
        using var file = WritableFile.Create(path);
        Save(file, format);
    }

    /// <summary>Writes the document to a stream.</summary>
    /// <param name="stream">The stream to write. It stays open.</param>
    /// <param name="format">The text layout; null for <see cref="TextFormat"/>, the layout that was read.</param>
    /// <exception cref="ArgumentException">The stream is not writable.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
    public void Save(Stream stream, CalculationTextFormat? format = null)
    {
        using var writer = new CalculationFileWriter(stream, ValueCount, format ?? TextFormat, leaveOpen: true);
        foreach (float[] row in _rows)
            writer.WriteFrame(row);
    }
}
