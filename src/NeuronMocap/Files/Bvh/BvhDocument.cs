using NeuronMocap.Files;

namespace NeuronMocap.Bvh;

/// <summary>
/// Represents a BVH file: a hierarchy of joints, and rows of values that move it. Immutable; thread-safe.
/// </summary>
/// <remarks>
/// <para>
/// A document holds the content of the file in the file's own order and units (Axis Neuron: centimetres and degrees). <see cref="BvhSkeletonMap"/>
/// finds the Neuron bones in it.
/// </para>
/// <para>
/// Reading is lenient. A defect with one sensible interpretation is read that way and listed in <see cref="Repairs"/>. Keywords are read in any
/// case. White space, blank lines and the kind of line ends have no meaning, except that a line end can end a row.
/// </para>
/// <para>
/// Each value is the binary32 number nearest to its text, including negative zero; NaN and infinity are kept. The rows determine the number of
/// frames, not the declared number. Several MOTION blocks are read as one take. A file that holds only a hierarchy is valid and has no frames.
/// </para>
/// </remarks>
public sealed class BvhDocument
{
    /// <summary>Maximum number of joints in a file.</summary>
    public const int MaxJoints = 10_000;

    /// <summary>Maximum number of values in a row.</summary>
    public const int MaxChannels = 100_000;

    /// <summary>Maximum nesting depth of joints.</summary>
    public const int MaxDepth = 512;

    /// <summary>Maximum number of entries in <see cref="Repairs"/>.</summary>
    public const int MaxListedRepairs = 100;

    private readonly float[] _values;

    /// <summary>Creates a document from values in memory.</summary>
    /// <param name="hierarchy">The joints.</param>
    /// <param name="frameTime">Time from one frame to the next, above 0.</param>
    /// <param name="values">
    /// The rows, one after the other. Each row has as many values as the hierarchy has channels. The array is not copied: do not change it after
    /// this call.
    /// </param>
    /// <exception cref="ArgumentException">The values are not a whole number of rows, or the frame time is 0.</exception>
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

    /// <summary>The joints in the order of the file, parents before their children. There is at least one.</summary>
    public IReadOnlyList<BvhJoint> Joints => Hierarchy.Joints;

    /// <summary>Number of values in a row.</summary>
    public int ChannelCount => Hierarchy.ChannelCount;

    /// <summary>Number of rows.</summary>
    public int FrameCount { get; }

    /// <summary>Seconds from one frame to the next as written in the file, often rounded; 0 when the file has no usable frame time.</summary>
    public double DeclaredFrameTime { get; private init; }

    /// <summary>
    /// Time from one frame to the next. If the file contains the rounded period of a usual rate, this is the exact period: see
    /// <see cref="BvhFrameTime.TryParse"/>. If the file has no usable frame time, this is 1/120 s.
    /// </summary>
    public BvhFrameTime FrameTime { get; }

    /// <summary>Frames per second, computed from <see cref="FrameTime"/>.</summary>
    public double FrameRate => FrameTime.FrameRate;

    /// <summary>The text layout of the file. A document created in memory has the layout of Axis Neuron.</summary>
    public BvhTextFormat TextFormat { get; init; } = BvhTextFormat.AxisNeuron;

    /// <summary>The first hundred defects of the file, and how each was read.</summary>
    public IReadOnlyList<BvhRepair> Repairs { get; private init; } = [];

    /// <summary>Number of repairs, including those that <see cref="Repairs"/> does not list.</summary>
    public int RepairCount { get; private init; }

    /// <summary>
    /// Number of rows and lines that were skipped because they have too few values or are not numeric. Declared rows that are missing do not count.
    /// </summary>
    public int SkippedRowCount { get; private init; }

    /// <summary>
    /// Number of skipped rows and lines that later rows follow. If they were rows of motion, the frames after them have earlier times than in the take.
    /// </summary>
    public int InnerSkippedRowCount { get; private init; }

    /// <summary>Number of frames that the file declares, see <see cref="BvhReader.DeclaredFrameCount"/>; null when it declares none.</summary>
    public long? DeclaredFrameCount { get; private init; }

    /// <summary>
    /// Reads a file into memory. If the file declares its number of frames, no more memory is allocated than the values need.
    /// <see cref="BvhReader"/> does not hold the values in memory.
    /// </summary>
    /// <param name="path">The path of the file.</param>
    /// <param name="options">The options; null for the defaults.</param>
    /// <returns>The document.</returns>
    /// <exception cref="BvhFormatException">
    /// The file is not BVH, exceeds a limit, or has more than 2^31 values. With <see cref="BvhReadOptions.Strict"/>: the file has a defect.
    /// </exception>
    /// <exception cref="IOException">The file does not exist or cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to read the file.</exception>
    public static BvhDocument Load(string path, BvhReadOptions? options = null)
    {
        using FileStream stream = BvhReader.OpenFile(path);
        return Load(stream, options);
    }

    /// <summary>Reads a stream to its end.</summary>
    /// <param name="stream">The stream to read, which may deliver pieces of any size. It stays open.</param>
    /// <param name="options">The options; null for the defaults.</param>
    /// <returns>The document.</returns>
    /// <exception cref="BvhFormatException">See <see cref="Load(string, BvhReadOptions)"/>.</exception>
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
    /// <param name="utf8">ASCII or UTF-8, with or without a byte order mark.</param>
    /// <param name="options">The options; null for the defaults. Progress is not reported.</param>
    /// <returns>The document, which does not keep a reference to the text.</returns>
    /// <exception cref="BvhFormatException">See <see cref="Load(string, BvhReadOptions)"/>.</exception>
    public static BvhDocument Parse(ReadOnlySpan<byte> utf8, BvhReadOptions? options = null) => Read(new BvhText(utf8), options);

    /// <summary>
    /// Writes the document to a file in the layout of <see cref="TextFormat"/>. Reading the file gives the same values, bit for bit, except for the
    /// kinds of NaN.
    /// </summary>
    /// <param name="path">The path of the file. An existing file is replaced.</param>
    /// <exception cref="IOException">The file cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to write the file.</exception>
    public void Save(string path)
    {
        using FileStream stream = WritableFile.Create(path);
        Save(stream);
    }

    /// <summary>Writes the document to a stream, as <see cref="Save(string)"/> does to a file.</summary>
    /// <param name="stream">The stream to write, from its current position. It stays open.</param>
    /// <exception cref="ArgumentException">The stream is not writable.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
    public void Save(Stream stream)
    {
        using var writer = new BvhWriter(stream, Hierarchy, FrameTime, TextFormat, leaveOpen: true, FrameCount);
        for (int frame = 0; frame < FrameCount; frame++)
            writer.WriteFrame(GetValues(frame));
    }

    /// <summary>Gets the values of one row, in the order of the file; see <see cref="BvhJoint.FirstChannel"/>.</summary>
    /// <param name="index">Number of the frame, from 0.</param>
    /// <returns><see cref="ChannelCount"/> values, in the document's own memory.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The frame does not exist.</exception>
    public ReadOnlySpan<float> GetValues(int index)
    {
        if ((uint)index >= (uint)FrameCount)
            throw new ArgumentOutOfRangeException(nameof(index), index, $"The index must be at least 0 and less than the number of frames, {FrameCount}.");

        return _values.AsSpan(index * ChannelCount, ChannelCount);
    }

    private static BvhDocument Read(BvhText text, BvhReadOptions? options)
    {
        var parser = new BvhParser(options);
        parser.Begin(ref text);
        var rows = new BvhRowBuffer(parser.Hierarchy.ChannelCount);
        rows.Reserve(parser.AnnouncedFrames, text.Remaining);
        int inner = 0;
        while (parser.TryReadRow(ref text, rows.Next))
        {
            rows.Keep(text.Place);
            inner = parser.Repairs.LeftOutCount;
        }

        return new BvhDocument(parser.Hierarchy, parser.FrameTime, rows.ToArray())
        {
            DeclaredFrameTime = parser.DeclaredFrameTime,
            TextFormat = parser.GetTextFormat(text.LineEnd),
            Repairs = parser.Repairs.Listed,
            RepairCount = parser.Repairs.Count,
            SkippedRowCount = parser.Repairs.LeftOutCount,
            InnerSkippedRowCount = inner,
            DeclaredFrameCount = parser.AnnouncedFrames,
        };
    }
}
