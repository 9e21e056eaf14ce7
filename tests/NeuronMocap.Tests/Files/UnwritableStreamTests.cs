using NeuronMocap.Bvh;
using NeuronMocap.Calculation;
using NeuronMocap.Csv;
using NeuronMocap.Gltf;
using NeuronMocap.Recording;
using NeuronMocap.Tests.Bvh;
using NeuronMocap.Tests.Calculation;

namespace NeuronMocap.Tests.Files;

// A writer refuses a stream that it could not write at the end of a take.
public sealed class UnwritableStreamTests
{
    private static readonly BvhDocument Take = BvhSamples.Parse(BvhSamples.TwoRows);
    private static readonly CalculationDocument Export = CalculationDocument.Parse(CalculationText.Utf8(CalculationText.Rows(1)));

    private static readonly Dictionary<string, Func<Stream, IDisposable>> Writers = new()
    {
        ["BVH"] = static stream => new BvhWriter(stream, Take.Hierarchy, BvhFrameTime.Default),
        ["calculation"] = static stream => new CalculationFileWriter(stream, CalculationFrame.FullValueCount),
        ["CSV"] = static stream => new PoseCsvWriter(stream),
        ["GLB"] = static stream => new GlbWriter(stream),
        ["recording"] = static stream => new RecordingWriter(stream),
    };

    public static TheoryData<string> Kinds => [.. Writers.Keys];

    [Theory, MemberData(nameof(Kinds))]
    public void A_stream_for_reading_is_refused_and_stays_open(string kind)
    {
        using var stream = new MemoryStream(new byte[10], writable: false);
        AssertRefused(() => Writers[kind](stream));
        Assert.True(stream.CanRead);
    }

    [Theory, MemberData(nameof(Kinds))]
    public void A_closed_stream_is_refused(string kind)
    {
        var stream = new MemoryStream();
        stream.Dispose();
        AssertRefused(() => Writers[kind](stream));
    }

    [Fact]
    public void Documents_are_not_saved_to_a_stream_for_reading()
    {
        using var stream = new MemoryStream(new byte[10], writable: false);
        Assert.Throws<ArgumentException>("stream", () => Take.Save(stream));
        Assert.Throws<ArgumentException>("stream", () => Export.Save(stream));
    }

    private static void AssertRefused(Func<IDisposable> open)
    {
        ArgumentException refused = Assert.Throws<ArgumentException>("stream", () => open().Dispose());
        Assert.Contains("not writable", refused.Message, StringComparison.Ordinal);
    }
}
