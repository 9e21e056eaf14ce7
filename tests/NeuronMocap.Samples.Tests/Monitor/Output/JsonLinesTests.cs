using System.Text;
using System.Text.Json;
using NeuronMocap.Delivery;
using NeuronMocap.Frames;
using NeuronMocap.Monitor.Output;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Samples.Tests.Monitor.Output;

public sealed class JsonLinesTests
{
    private readonly JsonLines _lines = new();

    [Fact]
    public void A_motion_frame_is_one_line_with_all_its_values()
    {
        var header = new MotionHeader { AvatarIndex = 3, AvatarName = new AvatarName("Char00"), FrameIndex = 12, HasDisplacement = true };
        var frame = new MotionFrame(header, [1.5f, -0f, 0f, 0.1f, 1e-7f, float.MaxValue, float.Epsilon]);

        Assert.Equal(
            """{"type":"frame","avatar":3,"name":"Char00","index":12,"displacement":true,"reference":false,"values":[1.5,-0.0,0,0.1,1E-07,3.4028235E+38,1E-45]}""" + "\n",
            Encoding.UTF8.GetString(_lines.Frame(frame)));
    }

    [Fact]
    public void What_is_not_finite_is_a_string()
    {
        var frame = new MotionFrame(new MotionHeader { FrameIndex = 1 }, [float.NaN, float.PositiveInfinity, float.NegativeInfinity]);

        Assert.EndsWith("\"values\":[\"NaN\",\"Infinity\",\"-Infinity\"]}\n", Encoding.UTF8.GetString(_lines.Frame(frame)), StringComparison.Ordinal);
    }

    [Fact]
    public void A_layout_without_a_counter_has_the_index_null()
    {
        var header = new MotionHeader { Version = DataVersion.Old, AvatarIndex = uint.MaxValue, HasReference = true };
        var frame = new MotionFrame(header, [1]);

        Assert.Equal(
            """{"type":"frame","avatar":4294967295,"name":"","index":null,"displacement":false,"reference":true,"values":[1]}""" + "\n",
            Encoding.UTF8.GetString(_lines.Frame(frame)));
    }

    [Fact]
    public void A_calculation_frame_has_no_flags()
    {
        var header = new CalculationHeader { AvatarIndex = 1, AvatarName = new AvatarName("a\"b"), FrameIndex = uint.MaxValue };
        var frame = new CalculationFrame(header, [2, -3]);

        Assert.Equal(
            """{"type":"calculation","avatar":1,"name":"a\u0022b","index":4294967295,"values":[2,-3]}""" + "\n",
            Encoding.UTF8.GetString(_lines.Calculation(frame)));
    }

    [Fact]
    public void A_studio_calculation_frame_has_the_numbers_of_each_bone_and_which_sensors_are_lost()
    {
        byte[] payload = new byte[StudioCalculationFrame.FullByteCount];
        for (int bone = 0; bone < 59; bone++)
        {
            for (int field = 0; field < 20; field++)
                BitConverter.TryWriteBytes(payload.AsSpan((bone * 84) + (field * 4)), bone + (field / 32f));
        }

        payload[(4 * 84) + 80] = 1;
        var header = new StudioCalculationHeader { AvatarIndex = 2, AvatarName = new AvatarName("chr00"), FrameIndex = 9 };
        using var line = JsonDocument.Parse(_lines.StudioCalculation(new StudioCalculationFrame(header, payload)).ToArray());
        JsonElement root = line.RootElement;
        Assert.Equal(
            ("studioCalculation", 2, "chr00", 9, 254, 59),
            (root.GetProperty("type").GetString(), root.GetProperty("avatar").GetInt32(), root.GetProperty("name").GetString(),
                root.GetProperty("index").GetInt32(), root.GetProperty("dataMask").GetInt32(), root.GetProperty("bones").GetInt32()));
        float[] values = [.. root.GetProperty("values").EnumerateArray().Select(value => value.GetSingle())];
        Assert.Equal(59 * 20, values.Length);
        Assert.Equal(58 + (19 / 32f), values[^1]);
        Assert.Equal([4], root.GetProperty("sensorsLost").EnumerateArray().Select(bone => bone.GetInt32()));

        using var other = JsonDocument.Parse(_lines.StudioCalculation(new StudioCalculationFrame(header with { DataMask = 2 }, payload.AsSpan(0, 8))).ToArray());
        Assert.Equal(0, other.RootElement.GetProperty("bones").GetInt32());
        Assert.Equal(2, other.RootElement.GetProperty("values").GetArrayLength());
    }

    [Fact]
    public void Status_and_summary_are_lines_too()
    {
        Assert.Equal(
            """{"type":"status","state":"Silent","message":"Nothing.","format":"Text"}""" + "\n",
            Encoding.UTF8.GetString(_lines.Status(new ConnectionStatus(ConnectionState.Silent, ConnectionReason.NoData, "Nothing.") { Format = StreamFormat.Text })));
        Assert.Equal(
            """{"type":"summary","frames":1,"calculationFrames":2,"lost":3,"dropped":4,"skippedBytes":5,"seconds":0,"gaps":6,"restarts":7,"reconnects":8,"studioCalculationFrames":9}""" + "\n",
            Encoding.UTF8.GetString(_lines.Summary(
                new ReaderStatistics
                {
                    MotionFrames = 1,
                    CalculationFrames = 2,
                    Lost = 3,
                    Dropped = 4,
                    SkippedBytes = 5,
                    Gaps = 6,
                    Restarts = 7,
                    Reconnects = 8,
                    StudioCalculationFrames = 9,
                })));
    }

    [Fact]
    public void Every_value_reads_back_to_the_same_bits()
    {
        var random = new Random(7001);
        float[] values = [.. Enumerable.Range(0, 10_000).Select(_ => BitConverter.Int32BitsToSingle(random.Next())).Where(float.IsFinite)];
        var frame = new MotionFrame(new MotionHeader { FrameIndex = 0 }, values);

        using JsonDocument document = JsonDocument.Parse(_lines.Frame(frame).ToArray());

        Assert.Equal(
            values.Select(BitConverter.SingleToInt32Bits),
            document.RootElement.GetProperty("values").EnumerateArray().Select(value => BitConverter.SingleToInt32Bits(value.GetSingle())));
    }

    [Fact]
    public void A_line_allocates_nothing_once_there_was_one_like_it()
    {
        var frame = new MotionFrame(
            new MotionHeader { AvatarName = new AvatarName("Char00"), FrameIndex = 1 }, [.. Enumerable.Range(0, 354).Select(index => index * 0.37f)]);
        _ = _lines.Frame(frame);

        // The runtime itself may allocate while it compiles a method anew; a line that allocates does so in every round.
        Assert.Contains(0, Enumerable.Range(0, 20).Select(_ => AllocatedBy(() => _lines.Frame(frame))));
    }

    private static long AllocatedBy(Func<ReadOnlySpan<byte>> makeLine)
    {
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < 100; i++)
            makeLine();

        return GC.GetAllocatedBytesForCurrentThread() - before;
    }
}
