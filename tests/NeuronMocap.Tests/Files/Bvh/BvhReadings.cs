using System.Globalization;
using System.Text;
using NeuronMocap.Bvh;

namespace NeuronMocap.Tests.Bvh;

/// <summary>Reads the same text in all ways, and compares the results down to the last bit and the last repair.</summary>
internal static class BvhReadings
{
    /// <summary>Describes everything about a document, or why it was rejected.</summary>
    public static string Describe(Func<BvhDocument> read)
    {
        try
        {
            BvhDocument document = read();
            var text = new StringBuilder();
            Append(text, document.Hierarchy, document.FrameTime, document.DeclaredFrameTime, document.TextFormat);
            for (int frame = 0; frame < document.FrameCount; frame++)
                Append(text, document.GetValues(frame));

            return Finish(text, document.Repairs, document.RepairCount);
        }
        catch (BvhFormatException refusal)
        {
            return $"refused: {refusal.Message} ({refusal.Line}, {refusal.Column})";
        }
    }

    public static string DescribeRows(Stream stream, BvhReadOptions? options = null)
    {
        try
        {
            using var reader = new BvhReader(stream, options);
            float[] row = new float[reader.Hierarchy.ChannelCount];
            var rows = new StringBuilder();
            long count = 0;
            while (reader.TryReadFrame(row))
            {
                Append(rows, row);
                Assert.Equal(++count, reader.FrameCount);
            }

            Assert.False(reader.TryReadFrame(row));
            var text = new StringBuilder();
            Append(text, reader.Hierarchy, reader.FrameTime, reader.DeclaredFrameTime, reader.TextFormat);
            return Finish(text.Append(rows), reader.Repairs, reader.RepairCount);
        }
        catch (BvhFormatException refusal)
        {
            return $"refused: {refusal.Message} ({refusal.Line}, {refusal.Column})";
        }
    }

    /// <summary>
    /// Asserts equal results for the text as a whole and in pieces, as a document and by rows. Strict readers accept it only if it needs no repair.
    /// </summary>
    /// <param name="text">The file.</param>
    /// <param name="seed">The seed of the pieces.</param>
    /// <returns>The result.</returns>
    public static string AssertAlike(byte[] text, int seed)
    {
        string whole = Describe(() => BvhDocument.Parse(text));
        var random = new Random(seed);
        int RandomSize() => random.Next(1, 1 << random.Next(1, 10));

        Assert.Equal(whole, Describe(() => BvhDocument.Load(new MemoryStream(text))));
        Assert.Equal(whole, Describe(() => BvhDocument.Load(new PieceStream(text, RandomSize))));
        Assert.Equal(whole, DescribeRows(new MemoryStream(text)));
        Assert.Equal(whole, DescribeRows(new PieceStream(text, static () => 1)));
        Assert.Equal(whole, DescribeRows(new PieceStream(text, RandomSize)));
        AssertStrict(text, whole);
        return whole;
    }

    // A strict reading rejects the first thing that a lenient one repairs or rejects, at the same place. Otherwise it gives the same result.
    private static void AssertStrict(byte[] text, string lenient)
    {
        var strict = new BvhReadOptions { Strict = true };
        string whole = Describe(() => BvhDocument.Parse(text, strict));
        Assert.Equal(whole, DescribeRows(new PieceStream(text, static () => 1), strict));

        var repairs = new List<BvhRepair>();
        try
        {
            repairs.AddRange(BvhDocument.Parse(text).Repairs);
        }
        catch (BvhFormatException)
        {
            Assert.StartsWith("refused: ", whole, StringComparison.Ordinal);
            return;
        }

        if (repairs.Count == 0)
        {
            Assert.Equal(lenient, whole);
            return;
        }

        Assert.EndsWith($"({repairs[0].Line}, {repairs[0].Column})", whole, StringComparison.Ordinal);
        string fault = whole[$"refused: line {repairs[0].Line}, column {repairs[0].Column}: ".Length..whole.LastIndexOf('.')];
        Assert.StartsWith(fault + "; ", repairs[0].Description, StringComparison.Ordinal);
    }

    private static void Append(StringBuilder text, BvhHierarchy hierarchy, BvhFrameTime time, double declared, BvhTextFormat format)
    {
        foreach (BvhJoint joint in hierarchy.Joints)
        {
            text.Append(CultureInfo.InvariantCulture, $"{joint.Index} {joint.Name} < {joint.Parent?.Index} at {joint.Offset:R} to {joint.EndSite:R}: ");
            text.Append(CultureInfo.InvariantCulture, $"{joint.FirstChannel} {string.Join(' ', joint.Channels)}\n");
        }

        text.Append(CultureInfo.InvariantCulture, $"{hierarchy.ChannelCount} channels, {time.Numerator}/{time.Denominator} = {declared:R} s, {format}\n");
    }

    private static void Append(StringBuilder text, ReadOnlySpan<float> row)
    {
        foreach (float value in row)
            text.Append(CultureInfo.InvariantCulture, $"{BitConverter.SingleToInt32Bits(value):X8} ");

        text.Append('\n');
    }

    private static string Finish(StringBuilder text, IReadOnlyList<BvhRepair> repairs, int count) =>
        text.AppendJoin('\n', repairs).Append(CultureInfo.InvariantCulture, $"\n{count} repairs").ToString();
}
