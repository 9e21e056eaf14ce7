using System.Numerics;
using System.Text;
using NeuronMocap.Calculation;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Calculation;

/// <summary>The header of an export, the kind of export, and impossible lengths.</summary>
public sealed class CalculationKindTests
{
    [Theory]
    [InlineData(240, false)]
    [InlineData(12, false)]
    [InlineData(1, true)]
    [InlineData(60, true)]
    public void Bone_ends_are_not_mistaken_for_centres(int frames, bool stands)
    {
        CalculationDocument document = Parse(BoneEnds.Write(frames, stands));
        Assert.Equal(frames, document.FrameCount);
        string message = Assert.Throws<CalculationFormatException>(() => CalculationSkeleton.Measure(document)).Message;
        Assert.Contains("the ends of the bones instead of their centres", message, StringComparison.Ordinal);
        Assert.Throws<CalculationFormatException>(() => new CalculationSource(document));
    }

    [Theory]
    [InlineData(240, false)]
    [InlineData(1, false)]
    [InlineData(60, true)]
    public void Bone_centres_are_not_mistaken_for_ends(int frames, bool stands) =>
        Assert.Empty(CalculationSkeleton.Measure(ActorExport.Write(frames, stands)).Warnings);

    [Fact]
    public void Impossible_lengths_are_reported()
    {
        var actor = new SyntheticSource(120);
        using var text = new MemoryStream();
        using (var writer = new CalculationFileWriter(text, CalculationFrame.FullValueCount, leaveOpen: true))
        {
            float[] values = new float[writer.ValueCount];
            for (int frame = 0; frame < 240; frame++)
            {
                CalculationSynthesizer.Write(actor, frame, values);
                foreach (Bone bone in (Bone[])[Bone.LeftLeg, Bone.LeftFoot])
                {
                    for (int i = 0; i < 3; i++)
                    {
                        int thigh = (CalculationOrder.IndexOf(Bone.LeftUpLeg) * 16) + i;
                        int value = (CalculationOrder.IndexOf(bone) * 16) + i;
                        values[value] = values[thigh] + (2 * (values[value] - values[thigh]));
                    }
                }

                CalculationAxes.Export.ConvertFromBvh(values);
                writer.WriteFrame(values);
            }
        }

        IReadOnlyList<string> warnings = CalculationSkeleton.Measure(CalculationDocument.Parse(text.ToArray())).Warnings;
        Assert.Contains(warnings, static warning => warning.Contains("lower leg", StringComparison.Ordinal));
        Assert.DoesNotContain(warnings, static warning => warning.Contains("arm", StringComparison.Ordinal));
    }

    [Fact]
    public void The_header_of_a_server_is_read()
    {
        CalculationDocument document = Parse(BoneEnds.Write(2));
        Assert.Equal(new Vector3(0.1736f, 0.9848f, 0), document.InitialDirection);
        Assert.Null(document.DeclaredFrameRate);
        using var copy = new MemoryStream();
        document.Save(copy);
        Assert.StartsWith("Zd:\t0.1736\t0.9848\t0.0000\r\nbones:\t59\r\n", Encoding.ASCII.GetString(copy.ToArray()), StringComparison.Ordinal);
    }

    [Fact]
    public void A_byte_order_mark_hides_no_header_line()
    {
        byte[] text = CalculationText.Utf8("\uFEFFFrame Rate:\t60\r\n" + CalculationText.Rows(3));
        CalculationDocument document = CalculationDocument.Parse(text);
        Assert.Equal((60, 3), (document.FrameRate, document.FrameCount));
        Assert.Equal(text, CalculationDocumentTests.Write(document));
        Assert.Equal(new Vector3(0.1736f, 0.9848f, 0), CalculationDocument.Parse(CalculationText.Utf8("\uFEFF" + BoneEnds.Write(2))).InitialDirection);
    }

    [Fact]
    public void A_byte_order_mark_hides_no_row()
    {
        byte[] text = CalculationText.Utf8("\uFEFF" + CalculationText.Rows(3));
        CalculationDocument document = CalculationDocument.Parse(text);
        Assert.Equal(3, document.FrameCount);
        Assert.Equal(CalculationText.Values(0), document.GetValues(0));
        Assert.Empty(document.Repairs);
        Assert.Equal(text, CalculationDocumentTests.Write(document));
    }

    [Theory]
    [InlineData("", "")]
    [InlineData("Frame Rate:\t60\r\n", "")]
    [InlineData("Frame Rate:\t60\r\nbones:\t59\r\n", "bones:\t59\r\n")]
    public void A_new_rate_leaves_the_byte_order_mark_in_front(string header, string others)
    {
        CalculationTextFormat format = CalculationDocument.Parse(CalculationText.Utf8("\uFEFF" + header + CalculationText.Rows(1))).TextFormat;
        Assert.Equal("\uFEFF" + others + "Frame Rate:\t120\r\n", Encoding.UTF8.GetString(format.WithFrameRate(120).Header.Span));
    }

    [Theory]
    [InlineData(60)]
    [InlineData(59.94)]
    [InlineData(23.976023976023978)]
    [InlineData(1e-3)]
    [InlineData(99999.5)]
    public void The_rate_is_kept_in_the_header(double rate)
    {
        CalculationDocument first = Parse(BoneEnds.Write(2));
        CalculationTextFormat format = first.TextFormat.WithFrameRate(120).WithFrameRate(rate);
        using var text = new MemoryStream();
        first.Save(text, format);
        CalculationDocument again = CalculationDocument.Parse(text.ToArray());

        Assert.Equal(rate, again.DeclaredFrameRate);
        Assert.Equal(rate, again.FrameRate);
        Assert.Equal(first.InitialDirection, again.InitialDirection);
        Assert.Equal(first.GetValues(1).ToArray(), again.GetValues(1).ToArray());
        Assert.Equal(50, CalculationDocument.Parse(text.ToArray(), new CalculationReadOptions { FrameRate = 50 }).FrameRate);
        Assert.Equal(first.TextFormat.Header.Length, format.Header.Length - Encoding.ASCII.GetString(format.Header.Span).Split('\n')[^2].Length - 1);
    }

    [Theory]
    [InlineData("Frame Rate: x")]
    [InlineData("Frame Rate: -1")]
    [InlineData("Frame Rate: NaN")]
    [InlineData("Frame Rate: 1e300")]
    [InlineData("Frame Rate:")]
    [InlineData("Zd: 1 2")]
    [InlineData("Zd: 1 2 NaN")]
    public void An_invalid_header_is_ignored(string line)
    {
        string bare = BoneEnds.Write(1);
        CalculationDocument document = Parse(line + "\n" + bare[bare.IndexOf("bones", StringComparison.Ordinal)..]);
        Assert.Equal(120, document.FrameRate);
        Assert.Null(document.DeclaredFrameRate);
        Assert.Null(document.InitialDirection);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-1)]
    [InlineData(double.NaN)]
    [InlineData(double.PositiveInfinity)]
    public void No_layout_accepts_an_invalid_rate(double rate) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => CalculationTextFormat.AxisNeuron.WithFrameRate(rate));

    [Fact]
    public void Dropped_rows_are_counted()
    {
        string text = BoneEnds.Write(3);
        CalculationDocument document = Parse(text + "1 2 x\r\n" + text[..^20][text.LastIndexOf("\r\n", text.Length - 3, StringComparison.Ordinal)..]);
        Assert.Equal(3, document.FrameCount);
        Assert.Equal(2, document.SkippedRowCount);
        Assert.Equal(2, document.RepairCount);
    }

    // The framework's own text differs between runtimes.
    [Theory]
    [InlineData(120, "120")]
    [InlineData(59.94, "59.94")]
    [InlineData(120.48192771084338, "120.48192771084338")]
    [InlineData(1 / 3d, "0.3333333333333333")]
    [InlineData(0.84551240822557006, "0.8455124082255701")]
    public void A_frame_rate_is_written_with_the_fewest_digits(double rate, string text) =>
        Assert.Contains($"\t{text}\r\n", Encoding.UTF8.GetString(CalculationTextFormat.AxisNeuron.WithFrameRate(rate).Header.Span), StringComparison.Ordinal);

    private static CalculationDocument Parse(string text) => CalculationDocument.Parse(Encoding.ASCII.GetBytes(text));
}
