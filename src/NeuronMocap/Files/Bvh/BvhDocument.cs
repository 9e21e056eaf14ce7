using NeuronMocap.Files;

namespace NeuronMocap.Bvh;

/// <summary>
/// A BVH file: a hierarchy of joints, and rows of values that move it. Holds what the file says, in its own order and units (Axis
/// Neuron: centimetres and degrees); <see cref="BvhSkeletonMap"/> finds Neuron's bones in it. Immutable; thread-safe.
/// <para>
/// Reading is lenient: what is wrong but has one sensible reading is read that way and listed in <see cref="Repairs"/>. Keywords are read in
/// any case; white space, blank lines and the kind of line ends have no meaning beyond ending a row. Values are the binary32 nearest to
/// their text, negative zero included; NaN and infinity are kept. Rows count, not the number that the file announces; several MOTION blocks
/// are read as one take. A file of a hierarchy alone is whole, with no frames.
/// </para>
/// </summary>
public sealed class BvhDocument
{
    /// <summary>Largest number of joints that is read.</summary>
    public const int MaxJoints = 10_000;

    /// <summary>Largest number of values in a row that is read.</summary>
    public const int MaxChannels = 100_000;

    /// <summary>Largest depth of joints within joints that is read.</summary>
    public const int MaxDepth = 512;

    /// <summary>Largest number of entries in <see cref="Repairs"/>.</summary>
    public const int MaxListedRepairs = 100;

    private readonly float[] _values;

    /// <summary>Makes a document of what is in memory.</summary>
    /// <param name="hierarchy">The joints.</param>
    /// <param name="frameTime">Time from one frame to the next, above 0.</param>
    /// <param name="values">
    /// The rows, one after the other, each of as many values as the hierarchy has channels. Not copied: the caller leaves them alone from here on.
    /// </param>
    /// <exception cref="ArgumentException">The values do not make whole rows, or the time is none.</exception>
    public BvhDocument(BvhHierarchy hierarchy, BvhFrameTime frameTime, float[] values)
    {
        ArgumentNullException.ThrowIfNull(hierarchy);
        ArgumentNullException.ThrowIfNull(values);
        if (frameTime == default)
            throw new ArgumentException("The frame time must be more than 0 s.", nameof(frameTime));
        if (hierarchy.ChannelCount == 0 ? values.Length > 0 : values.Length % hierarchy.ChannelCount != 0)
            throw new ArgumentException($"{values.Length} values are not a multiple of {hierarchy.ChannelCount}, the length of a row.", nameof(values));

        Hierarchy = hierarchy;
        FrameTime = frameTime;
        DeclaredFrameTime = frameTime.Seconds;
        FrameCount = hierarchy.ChannelCount == 0 ? 0 : values.Length / hierarchy.ChannelCount;
        _values = values;
    }

    /// <summary>The joints and their channels.</summary>
    public BvhHierarchy Hierarchy { get; }

    /// <summary>The joints, parents before their children, in the order of the file; at least one.</summary>
    public IReadOnlyList<BvhJoint> Joints => Hierarchy.Joints;

    /// <summary>Number of values in a row.</summary>
    public int ChannelCount => Hierarchy.ChannelCount;

    /// <summary>Number of rows that are there.</summary>
    public int FrameCount { get; }

    /// <summary>Seconds from one frame to the next as the file has it, often rounded; 0 when it has none that is usable.</summary>
    public double DeclaredFrameTime { get; private init; }

    /// <summary>
    /// Time from one frame to the next. Where the file's is the rounded period of a usual rate, that period: see
    /// <see cref="BvhFrameTime.TryParse"/>. Where the file has none, 1/120 s.
    /// </summary>
    public BvhFrameTime FrameTime { get; }

    /// <summary>Frames per second, by <see cref="FrameTime"/>.</summary>
    public double FrameRate => FrameTime.FrameRate;

    /// <summary>How the text of the file is laid out; of a document that was made in memory, as Axis Neuron does it.</summary>
    public BvhTextFormat TextFormat { get; init; } = BvhTextFormat.AxisNeuron;

    /// <summary>What was wrong in the file and how it was read all the same; the first hundred.</summary>
    public IReadOnlyList<BvhRepair> Repairs { get; private init; } = [];

    /// <summary>Number of repairs, those included that <see cref="Repairs"/> does not list.</summary>
    public int RepairCount { get; private init; }

    /// <summary>Number of rows and lines that were left out, for they have too few values or no numbers. Rows that the file announces and lacks do not count.</summary>
    public int SkippedRowCount { get; private init; }

    /// <summary>Number of frames that the file announces, see <see cref="BvhReader.DeclaredFrameCount"/>; null when it does not.</summary>
    public long? DeclaredFrameCount { get; private init; }

    /// <summary>Reads a file. Takes the memory of the values, and no more where the file says how many there are; <see cref="BvhReader"/> takes none.</summary>
    /// <param name="path">Where it is.</param>
    /// <param name="options">How to read it; null for the defaults.</param>
    /// <returns>The document.</returns>
    /// <exception cref="BvhFormatException">
    /// The file is not BVH, exceeds one of the limits, or has more than 2^31 values; with <see cref="BvhReadOptions.Strict"/>, anything is wrong.
    /// </exception>
    /// <exception cref="IOException">The file is not there or cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">This user may not read it.</exception>
    public static BvhDocument Load(string path, BvhReadOptions? options = null)
    {
        using FileStream stream = BvhReader.OpenFile(path);
        return Load(stream, options);
    }

    /// <summary>Reads a stream to its end.</summary>
    /// <param name="stream">Where the text comes from, in pieces of any size; not closed.</param>
    /// <param name="options">How to read it; null for the defaults.</param>
    /// <returns>The document.</returns>
    /// <exception cref="BvhFormatException">As when a file is read.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
    public static BvhDocument Load(Stream stream, BvhReadOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(stream);
        var source = new BvhTextSource(stream, options?.Progress);
        try
        {
            return Read(new BvhText(source), options);
        }
        finally
        {
            source.Release();
        }
    }

    /// <summary>Reads text.</summary>
    /// <param name="utf8">ASCII or UTF-8, with or without a byte order mark; only read.</param>
    /// <param name="options">How to read it; null for the defaults. Progress is not reported.</param>
    /// <returns>The document, which does not refer to the text any more.</returns>
    /// <exception cref="BvhFormatException">As when a file is read.</exception>
    public static BvhDocument Parse(ReadOnlySpan<byte> utf8, BvhReadOptions? options = null) => Read(new BvhText(utf8), options);

    /// <summary>Writes the document as a file, laid out by <see cref="TextFormat"/>. Read again it has the same values, bit for bit, except for the kinds of NaN.</summary>
    /// <param name="path">Where; a file that is there already is replaced.</param>
    /// <exception cref="IOException">The file cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">This user may not write it.</exception>
    public void Save(string path)
    {
        using FileStream stream = WritableFile.Create(path);
        Save(stream);
    }

    /// <summary>Writes the document to a stream; otherwise as <see cref="Save(string)"/>.</summary>
    /// <param name="stream">Where, from its position on; it stays open.</param>
    /// <exception cref="ArgumentException">The stream cannot be written.</exception>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public void Save(Stream stream)
    {
        using var writer = new BvhWriter(stream, Hierarchy, FrameTime, TextFormat, leaveOpen: true, FrameCount);
        for (int frame = 0; frame < FrameCount; frame++)
            writer.WriteFrame(GetFrame(frame));
    }

    /// <summary>The values of one row, in the order of the file; see <see cref="BvhJoint.FirstChannel"/>.</summary>
    /// <param name="index">Number of the frame, from 0.</param>
    /// <returns>As many values as <see cref="ChannelCount"/>, in the document's own memory.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such frame.</exception>
    public ReadOnlySpan<float> GetFrame(int index)
    {
        if ((uint)index >= (uint)FrameCount)
            throw new ArgumentOutOfRangeException(nameof(index), index, $"There are {FrameCount} frames.");

        return _values.AsSpan(index * ChannelCount, ChannelCount);
    }

    private static BvhDocument Read(BvhText text, BvhReadOptions? options)
    {
        var parser = new BvhParser(options);
        parser.Begin(ref text);
        var rows = new BvhRowBuffer(parser.Hierarchy.ChannelCount);
        rows.Reserve(parser.AnnouncedFrames, text.Remaining);
        while (parser.TryReadRow(ref text, rows.Next))
            rows.Keep(text.Place);

        return new BvhDocument(parser.Hierarchy, parser.FrameTime, rows.ToArray())
        {
            DeclaredFrameTime = parser.DeclaredFrameTime,
            TextFormat = parser.GetTextFormat(text.LineEnd),
            Repairs = parser.Repairs.Listed,
            RepairCount = parser.Repairs.Count,
            SkippedRowCount = parser.Repairs.LeftOutCount,
            DeclaredFrameCount = parser.AnnouncedFrames,
        };
    }
}
