using System.Numerics;
using NeuronMocap.Files;

namespace NeuronMocap.Calculation;

/// <summary>
/// A calculation export, the .calc file of Axis Neuron: rows of text with the values of calculation frames, in the order of the calculation stream
/// (manual, Appendix C; docs/guide/calculation.md has the columns). Immutable once read; thread-safe.
/// <para>
/// Reading is lenient: what is wrong but has one sensible reading is read that way and listed in <see cref="Repairs"/>. What stands above the first
/// row is a header, kept in <see cref="TextFormat"/>. White space of any kind parts values, also behind the last one; blank lines and the kind of line
/// ends have no meaning. Values are the binary32 nearest to their text, negative zero included; NaN and infinity are kept. A row that lacks
/// values, as the last one of a file that was cut, is left out.
/// </para>
/// </summary>
public sealed class CalculationDocument
{
    /// <summary>Largest number of entries in <see cref="Repairs"/>.</summary>
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

    /// <summary>Values in each row: 946 for 59 bones, or 338 for 21.</summary>
    public int ValueCount { get; }

    /// <summary>Frames per second: the options' rate, or <see cref="DeclaredFrameRate"/>, or 120.</summary>
    public double FrameRate { get; }

    /// <summary>Frames per second as the file's header says; null where it does not. Axis Neuron's exports do not, this library's do.</summary>
    public double? DeclaredFrameRate { get; }

    /// <summary>
    /// The direction that the actor faces at the start, in the file's axes: the line <c>Zd:</c> of the header. Null where there is none.
    /// </summary>
    public Vector3? InitialDirection { get; }

    /// <summary>How the text of the file looks.</summary>
    public CalculationTextFormat TextFormat { get; }

    /// <summary>What was wrong in the file and how it was read all the same; the first hundred.</summary>
    public IReadOnlyList<CalculationRepair> Repairs { get; }

    /// <summary>Number of repairs, those included that <see cref="Repairs"/> does not list.</summary>
    public int RepairCount { get; }

    /// <summary>Number of lines that are no row and were left out.</summary>
    public int SkippedRowCount { get; }

    /// <summary>Reads a file. It needs 4 bytes for each of its values; <see cref="CalculationFileReader"/> reads one of any length.</summary>
    /// <param name="path">Where it is.</param>
    /// <param name="options">How to read it; null is the same as the defaults.</param>
    /// <returns>The document.</returns>
    /// <exception cref="CalculationFormatException">There is no row of 946 or 338 numbers, or reading is strict and something is wrong.</exception>
    /// <exception cref="IOException">The file is not there or cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">This user may not read it.</exception>
    public static CalculationDocument Load(string path, CalculationReadOptions? options = null)
    {
        using FileStream stream = CalculationFileReader.OpenFile(path);
        return Load(stream, options);
    }

    /// <summary>Reads a stream to its end.</summary>
    /// <param name="stream">Where the text comes from, in pieces of any size; not closed.</param>
    /// <param name="options">How to read it; null is the same as the defaults.</param>
    /// <returns>The document.</returns>
    /// <exception cref="CalculationFormatException">There is no row of 946 or 338 numbers, or reading is strict and something is wrong.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
    public static CalculationDocument Load(Stream stream, CalculationReadOptions? options = null)
    {
        using var reader = new CalculationFileReader(stream, options, leaveOpen: true);
        return new CalculationDocument(reader);
    }

    /// <summary>Reads text.</summary>
    /// <param name="utf8">ASCII or UTF-8; only read.</param>
    /// <param name="options">How to read it; null is the same as the defaults.</param>
    /// <returns>The document, which does not refer to the text any more.</returns>
    /// <exception cref="CalculationFormatException">There is no row of 946 or 338 numbers, or reading is strict and something is wrong.</exception>
    public static CalculationDocument Parse(ReadOnlySpan<byte> utf8, CalculationReadOptions? options = null)
    {
        using var text = new MemoryStream(utf8.ToArray(), writable: false);
        return Load(text, options);
    }

    /// <summary>The values of a frame, in the order of the calculation stream.</summary>
    /// <param name="index">Number of the frame, from 0.</param>
    /// <returns>As many values as <see cref="ValueCount"/>, in the document's own memory.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such frame.</exception>
    public ReadOnlySpan<float> GetValues(int index)
    {
        if ((uint)index >= (uint)FrameCount)
            throw new ArgumentOutOfRangeException(nameof(index), index, $"There are {FrameCount} frames.");

        return _rows[index];
    }

    /// <summary>A frame, as a stream of the same values would give it; its <see cref="AvatarFrame.FrameIndex"/> is its number.</summary>
    /// <param name="index">Number of the frame, from 0.</param>
    /// <returns>A frame that owns its memory; a new one on every call.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such frame.</exception>
    public CalculationFrame GetFrame(int index)
    {
        ReadOnlySpan<float> values = GetValues(index);
        return new CalculationFrame(_header with { FrameIndex = (uint)index }, values);
    }

    /// <summary>Which feet touch the ground in a frame.</summary>
    /// <param name="index">Number of the frame, from 0.</param>
    /// <returns>The frame's flags.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such frame.</exception>
    public FootContacts GetFootContacts(int index)
    {
        ReadOnlySpan<float> flags = GetValues(index)[(CalculationFrame.BodyValueCount - 2)..];
        return new FootContacts(flags[0] != 0, flags[1] != 0);
    }

    /// <summary>Writes the file, over one that is there.</summary>
    /// <param name="path">Where to.</param>
    /// <param name="format">How the text shall look; null as it was read: <see cref="TextFormat"/>.</param>
    /// <exception cref="IOException">The file cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">This user may not write it.</exception>
    public void Save(string path, CalculationTextFormat? format = null)
    {
        using var file = WritableFile.Create(path);
        Save(file, format);
    }

    /// <summary>Writes the text.</summary>
    /// <param name="stream">Where to; left open.</param>
    /// <param name="format">How the text shall look; null as it was read: <see cref="TextFormat"/>.</param>
    /// <exception cref="IOException">The text cannot be written.</exception>
    public void Save(Stream stream, CalculationTextFormat? format = null)
    {
        using var writer = new CalculationFileWriter(stream, ValueCount, format ?? TextFormat, leaveOpen: true);
        foreach (float[] row in _rows)
            writer.WriteFrame(row);
    }
}
