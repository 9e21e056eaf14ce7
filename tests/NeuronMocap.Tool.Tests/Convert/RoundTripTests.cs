using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Calculation;
using NeuronMocap.Recording;
using NeuronMocap.Tests.Calculation;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;
using static NeuronMocap.Tool.Tests.Convert.Conversion;
using static NeuronMocap.Tool.Tests.Convert.TakeComparison;

namespace NeuronMocap.Tool.Tests.Convert;

public sealed class RoundTripTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    [Theory]
    [InlineData(true, RotationOrder.YXZ)]
    [InlineData(false, RotationOrder.ZYX)]
    public async Task A_take_and_its_body_round_trip_through_a_recording(bool displacement, RotationOrder order)
    {
        Takes.Actor(120, displacement: displacement, order: order).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.nmrec"]);
        await ConvertAsync(_folder["take.nmrec"], _folder["back.bvh"]);

        AssertSame(BvhDocument.Load(_folder["take.bvh"]), BvhDocument.Load(_folder["back.bvh"]));
        using RecordingReader recording = RecordingReader.Open(_folder["take.nmrec"]);
        Assert.Equal(order.ToString(), recording.Metadata[RecordingMetadata.RotationOrderKey]);
        Assert.Equal(TimeSpan.FromTicks((long)Math.Round(119 * TimeSpan.TicksPerSecond / 60.0)), recording.Duration);
    }

    // No packet of Axis Neuron carries the order of the stream. The option sets it, and the values stay the same.
    [Fact]
    public async Task The_given_order_of_raw_bytes_is_kept()
    {
        Takes.Actor(60, order: RotationOrder.XYZ).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.bin"]);
        await ConvertAsync(_folder["take.bin"], _folder["back.bvh"], "--order", "xyz");

        Assert.Equal(Values(BvhDocument.Load(_folder["take.bvh"])), Values(BvhDocument.Load(_folder["back.bvh"])));
        Assert.True(BvhSkeletonMap.TryCreate(BvhDocument.Load(_folder["back.bvh"]), out BvhSkeletonMap? map, out _));
        Assert.Equal(RotationOrder.XYZ, map.Format.RotationOrder);
    }

    // A calculation export has centres of bones and sensors, but no joints. The joints are found from the motion, best for walking legs.
    [Fact]
    public async Task A_take_nearly_survives_calculation_data()
    {
        Takes.Actor(300, rate: 120).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.calc"]);
        await ConvertAsync(_folder["take.calc"], _folder["back.bvh"]);

        Vector3[][] expected = Joints(BvhDocument.Load(_folder["take.bvh"]));
        Vector3[][] actual = Joints(BvhDocument.Load(_folder["back.bvh"]));
        Assert.Equal(expected.Length, actual.Length);
        for (Bone bone = Bone.Hips; bone <= Bone.LeftFoot; bone++)
        {
            float farthest = Enumerable.Range(0, expected.Length).Max(frame => Vector3.Distance(expected[frame][(int)bone], actual[frame][(int)bone]));
            Assert.True(farthest < 1, $"{bone} is {farthest} cm from its place.");
        }
    }

    // Rates that no server uses, and times that are not a whole number of ticks.
    [Theory]
    [InlineData(60)]
    [InlineData(90)]
    [InlineData(120)]
    [InlineData(59.94)]
    [InlineData(97.3)]
    [InlineData(23.976023976023978)]
    [InlineData(1000)]
    public async Task Frames_times_and_values_round_trip_through_every_format(double rate)
    {
        Takes.Actor(100, rate: rate).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.nmrec"]);
        await ConvertAsync(_folder["take.nmrec"], _folder["back.bvh"]);
        AssertSame(BvhDocument.Load(_folder["take.bvh"]), BvhDocument.Load(_folder["back.bvh"]));
        await ConvertAsync(_folder["back.bvh"], _folder["again.nmrec"]);
        AssertSameFrames(_folder["take.nmrec"], _folder["again.nmrec"]);

        await ConvertAsync(_folder["take.nmrec"], _folder["take.calc"]);
        await ConvertAsync(_folder["take.calc"], _folder["calculation.nmrec"]);
        await ConvertAsync(_folder["calculation.nmrec"], _folder["back.calc"]);
        Assert.Equal(await File.ReadAllBytesAsync(_folder["take.calc"], Token), await File.ReadAllBytesAsync(_folder["back.calc"], Token));
        Assert.Equal(Times(_folder["take.nmrec"]), Times(_folder["calculation.nmrec"]));
        await ConvertAsync(_folder["back.calc"], _folder["again.calculation.nmrec"]);
        AssertSameFrames(_folder["calculation.nmrec"], _folder["again.calculation.nmrec"]);

        await ConvertAsync(_folder["take.calc"], _folder["poses.bvh"]);
        Assert.Equal(BvhDocument.Load(_folder["take.bvh"]).FrameTime, BvhDocument.Load(_folder["poses.bvh"]).FrameTime);

        string given = rate.ToString(System.Globalization.CultureInfo.InvariantCulture);
        await ConvertAsync(_folder["take.nmrec"], _folder["take.bin"]);
        await ConvertAsync(_folder["take.bin"], _folder["timed.nmrec"], "--rate", given);
        Assert.Equal(Times(_folder["take.nmrec"]).Select(static time => time / TimeSpan.FromSeconds(1)), Times(_folder["timed.nmrec"]).Select(static time => time / TimeSpan.FromSeconds(1)), new Near(2e-7));
    }

    [Fact]
    public async Task An_export_of_bone_ends_keeps_its_rows_but_has_no_body()
    {
        _folder.Write("ends.calc", BoneEnds.Write(60));
        ToolResult refused = await ToolRunner.RunAsync("convert", _folder["ends.calc"], _folder["ends.bvh"]);
        Assert.Equal(1, refused.ExitCode);
        Assert.Contains("the ends of the bones instead of their centres", Assert.Single(refused.Error), StringComparison.Ordinal);
        Assert.Equal(1, (await ToolRunner.RunAsync("plot", _folder["ends.calc"], _folder["ends.svg"])).ExitCode);
        Assert.Equal(["ends.calc"], _folder.Names);

        await ConvertAsync(_folder["ends.calc"], _folder["ends.nmrec"]);
        await ConvertAsync(_folder["ends.nmrec"], _folder["back.calc"]);
        AssertSame(CalculationDocument.Load(_folder["ends.calc"]), CalculationDocument.Load(_folder["back.calc"]));

        ToolResult info = await ToolRunner.RunAsync("info", _folder["ends.calc"]);
        Assert.Equal(0, info.ExitCode);
        Assert.Contains(info.Output, static line => line.Contains("the ends of the bones instead of their centres", StringComparison.Ordinal));
        Assert.Contains(info.Output, static line => line.Contains("0.1736 0.9848 0 in the file's axes", StringComparison.Ordinal));
        Assert.DoesNotContain(info.Output, static line => line.Contains("upper leg", StringComparison.Ordinal));
    }

    // The copy has no damaged block. Without a loss in its place, the first part of the packet would continue with another packet.
    [Fact]
    public async Task A_copy_of_a_damaged_recording_has_the_same_frames()
    {
        byte[] split = FrameServer.Calculation(1, Ramp(1));
        long start, end;
        using (RecordingWriter writer = RecordingWriter.Create(_folder["take.nmrec"]))
        {
            writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, string.Empty, string.Empty));
            writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(1, TransportKind.Tcp, string.Empty, string.Empty) { IsCalculation = true });
            writer.WriteBytes(TimeSpan.FromSeconds(1), 1, [.. FrameServer.Calculation(0, Ramp(0)), .. split[..1000]]);
            writer.Flush();
            start = writer.WrittenLength;
            writer.WriteBytes(TimeSpan.FromSeconds(2), 0, new byte[500]);
            writer.Flush();
            end = writer.WrittenLength;
            writer.WriteBytes(TimeSpan.FromSeconds(3), 1, split.AsSpan(1000));
            writer.WriteBytes(TimeSpan.FromSeconds(4), 1, FrameServer.Calculation(2, Ramp(2)));
        }

        byte[] bytes = await File.ReadAllBytesAsync(_folder["take.nmrec"], Token);
        bytes[(start + end) / 2] ^= 1;
        await File.WriteAllBytesAsync(_folder["take.nmrec"], bytes, Token);
        await ConvertAsync(_folder["take.nmrec"], _folder["copy.nmrec"]);

        Assert.Equal([1.0, 4], Times(_folder["take.nmrec"]).Select(static time => time.TotalSeconds));
        AssertSameFrames(_folder["take.nmrec"], _folder["copy.nmrec"]);
        using RecordingReader copy = RecordingReader.Open(_folder["copy.nmrec"]);
        Assert.Empty(copy.Problems);
        Assert.Equal((2, end - start), (copy.Totals!.Value.LostPieces, copy.Totals.Value.LostBytes));

        static float[] Ramp(int frame) => [.. Enumerable.Range(0, 946).Select(i => frame + (i / 1024f))];
    }

    public void Dispose() => _folder.Dispose();

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    private sealed class Near(double tolerance) : IEqualityComparer<double>
    {
        public bool Equals(double x, double y) => Math.Abs(x - y) <= tolerance;

        public int GetHashCode(double obj) => 0;
    }
}
