using System.Diagnostics;
using System.Net;
using System.Numerics;
using System.Text;
using System.Text.Json;
using NeuronMocap.Json;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Output;

public sealed class JsonLinesTests
{
    // An event before the start has the time of the start.
    private const string Origin = "\"sender\":0,\"time\":0,\"utc\":\"2026-01-02T03:04:05Z\"";

    private readonly JsonLines _lines = new(new JsonClock(long.MaxValue, new DateTime(2026, 1, 2, 3, 4, 5, DateTimeKind.Utc)));

    [Fact]
    public void A_motion_frame_is_one_line_with_all_its_values()
    {
        var header = new MotionHeader { AvatarIndex = 3, AvatarName = new AvatarName("Char00"), FrameIndex = 12, HasDisplacement = true };
        var frame = new MotionFrame(header, [1.5f, -0f, 0f, 0.1f, 1e-7f, float.MaxValue, float.Epsilon]);

        Assert.Equal(
            $$"""{"type":"frame","avatar":3,"name":"Char00","index":12,"displacement":true,"reference":false,{{Origin}},"rotationOrder":"YXZ","timecode":null,"positions":null,"values":[1.5,-0.0,0,0.1,1E-07,3.4028235E+38,1E-45]}""" + "\n",
            Encoding.UTF8.GetString(_lines.Frame(frame)));
    }

    [Fact]
    public void A_frame_has_the_world_positions_of_its_bones()
    {
        using var document = JsonDocument.Parse(_lines.Frame(Poses.Upright(x: 25)).ToArray());
        float[] positions = [.. document.RootElement.GetProperty("positions").EnumerateArray().Select(static value => value.GetSingle())];

        Assert.Equal(59 * 3, positions.Length);
        Assert.Equal([25, DefaultOffsets.Get(Bone.Hips).Y, 0], positions[..3]);
        Vector3 knee = DefaultOffsets.Get(Bone.RightUpLeg) + DefaultOffsets.Get(Bone.RightLeg);
        Assert.Equal(positions[0] + knee.X, positions[3 * (int)Bone.RightLeg], 0.01f);
        Assert.Equal(positions[1] + knee.Y, positions[(3 * (int)Bone.RightLeg) + 1], 0.01f);
    }

    [Fact]
    public void Time_and_timecode_come_from_the_frame()
    {
        var header = new MotionHeader { Version = DataVersion.Studio, Reserved1 = 0x0A0B0C, Reserved2 = 7 };
        var frame = new MotionFrame(header, [1]);
        var lines = new JsonLines(new JsonClock(frame.Timestamp - (Stopwatch.Frequency * 5 / 2), new DateTime(2026, 1, 2, 3, 4, 5, DateTimeKind.Utc)));
        using var document = JsonDocument.Parse(lines.Frame(frame).ToArray());

        Assert.Equal(2.5, document.RootElement.GetProperty("time").GetDouble());
        Assert.Equal("2026-01-02T03:04:07.5Z", document.RootElement.GetProperty("utc").GetString());
        Assert.Equal("10:11:12:07", $"{frame.Timecode}");
        Assert.Equal("10:11:12:07", document.RootElement.GetProperty("timecode").GetString());
    }

    [Fact]
    public void A_skeleton_line_is_written_once_per_avatar_and_change()
    {
        var told = new SkeletonChanges();
        Assert.True(told.IsNew(Poses.Upright()));
        Assert.False(told.IsNew(Poses.Upright(index: 1)));
        Assert.True(told.IsNew(new MotionFrame(new MotionHeader(), new float[354])));
        Assert.True(told.IsNew(new MotionFrame(new MotionHeader(), new float[354], new SkeletonFormat(RotationOrder.XYZ, SkeletonVariant.Neck1))));
        Assert.True(told.IsNew(new MotionFrame(new MotionHeader { AvatarIndex = 1 }, new float[354])));

        using var document = JsonDocument.Parse(_lines.Skeleton(Poses.Upright()).ToArray());
        Assert.Equal("Hips", document.RootElement.GetProperty("bones")[0].GetString());
        Assert.Equal(-1, document.RootElement.GetProperty("parents")[0].GetInt32());
        Assert.Equal(59, document.RootElement.GetProperty("bones").GetArrayLength());
        Assert.Equal(59, document.RootElement.GetProperty("parents").GetArrayLength());
    }

    [Fact]
    public void Values_that_are_not_finite_are_strings()
    {
        var frame = new MotionFrame(new MotionHeader { FrameIndex = 1 }, [float.NaN, float.PositiveInfinity, float.NegativeInfinity]);

        Assert.EndsWith("\"values\":[\"NaN\",\"Infinity\",\"-Infinity\"]}\n", Encoding.UTF8.GetString(_lines.Frame(frame)), StringComparison.Ordinal);
    }

    [Fact]
    public void A_frame_without_an_index_has_null()
    {
        var header = new MotionHeader { Version = DataVersion.Old, AvatarIndex = -1, HasReference = true };
        var frame = new MotionFrame(header, [1]);

        Assert.Equal(
            $$"""{"type":"frame","avatar":4294967295,"name":"","index":null,"displacement":false,"reference":true,{{Origin}},"rotationOrder":"YXZ","timecode":null,"positions":null,"values":[1]}""" + "\n",
            Encoding.UTF8.GetString(_lines.Frame(frame)));
    }

    [Fact]
    public void A_calculation_frame_has_no_flags()
    {
        var header = new CalculationHeader { AvatarIndex = 1, AvatarName = new AvatarName("a\"b"), FrameIndex = uint.MaxValue };
        var frame = new CalculationFrame(header, [2, -3]);

        Assert.Equal(
            $$"""{"type":"calculation","avatar":1,"name":"a\u0022b","index":4294967295,{{Origin}},"values":[2,-3]}""" + "\n",
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
    public void Status_and_summary_are_lines()
    {
        Assert.Equal(
            """{"type":"status","state":"Silent","message":"Nothing.","format":"Text","reason":"no-data","attempt":2,"retryIn":null,"local":"127.0.0.1:7012","remote":null,"receiveBuffer":212992,"time":0,"utc":"2026-01-02T03:04:05Z","receiveBufferRequested":4194304}""" + "\n",
            Encoding.UTF8.GetString(_lines.Status(new ConnectionStatus(ConnectionState.Silent, ConnectionReason.NoData, "Nothing.")
            {
                Format = StreamFormat.Text,
                Attempt = 2,
                LocalEndPoint = new IPEndPoint(IPAddress.Loopback, 7012),
                ReceiveBufferSize = 212_992,
            })));
        Assert.Equal(
            """{"type":"summary","frames":1,"calculationFrames":2,"lost":3,"dropped":4,"skippedBytes":5,"seconds":0,"gaps":6,"restarts":7,"reconnects":8,"studioCalculationFrames":9,"refusedDatagrams":10,"calculationReconnects":11,"time":0,"utc":"2026-01-02T03:04:05Z","rejectedMessages":12}""" + "\n",
            Encoding.UTF8.GetString(_lines.Summary(
                new ReaderStatistics
                {
                    MotionFrames = 1,
                    CalculationFrames = 2,
                    Lost = 3,
                    Dropped = 4,
                    BytesSkipped = 5,
                    Gaps = 6,
                    Restarts = 7,
                    Reconnects = 8,
                    StudioCalculationFrames = 9,
                    RefusedDatagrams = 10,
                    CalculationReconnects = 11,
                    RejectedMessages = 12,
                })));
    }

    [Fact]
    public void Every_value_round_trips_bit_for_bit()
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
    public void A_repeated_line_allocates_nothing()
    {
        var frame = new MotionFrame(
            new MotionHeader { Version = DataVersion.Studio, AvatarName = new AvatarName("Char00"), FrameIndex = 1, Reserved1 = 0x0A0B0C }, [.. Enumerable.Range(0, 354).Select(index => index * 0.37f)]);
        _ = _lines.Frame(frame);

        Allocations.AssertNone(() => _ = _lines.Frame(frame));
    }
}
