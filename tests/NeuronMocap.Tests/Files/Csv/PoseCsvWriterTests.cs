using System.Globalization;
using System.Numerics;
using System.Text;
using NeuronMocap.Csv;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Csv;

public sealed class PoseCsvWriterTests
{
    private const int FirstBone = 4;

    [Fact]
    public void Values_read_back_as_the_same_bits()
    {
        BoneTransform[] pose = Random(7);
        float[] row = [.. Lines(Write(writer => writer.WriteRow(default, pose), new PoseCsvOptions { Unit = LengthUnit.Centimetres }))[1].Split(',')[FirstBone..].Select(Parse)];

        for (int bone = 0; bone < pose.Length; bone++)
        {
            (Vector3 position, Quaternion rotation) = pose[bone];
            Assert.Equal([position.X, position.Y, position.Z, rotation.X, rotation.Y, rotation.Z, rotation.W], row[(bone * 7)..((bone * 7) + 7)]);
        }
    }

    [Fact]
    public void Z_up_has_x_forward_and_y_to_the_left()
    {
        BoneTransform[] pose = Random(3);
        pose[0] = new BoneTransform(new Vector3(10, 200, 3000), new Quaternion(0.1f, 0.2f, 0.3f, 0.9273618f));
        string row = Lines(Write(writer => writer.WriteRow(default, pose), new PoseCsvOptions { UpAxis = UpAxis.Z }))[1];
        Assert.StartsWith("0,0,,,30,0.1,2,0.3,0.1,0.2,0.9273618,", row, StringComparison.Ordinal);
    }

    [Fact]
    public void Units_and_numbers_are_in_the_row()
    {
        BoneTransform[] pose = Random(3);
        pose[0] = new BoneTransform(new Vector3(150, -0.1f, 1e-6f), Quaternion.Identity);
        string text = Write(writer => writer.WriteRow(TimeSpan.FromTicks(123_450_000), pose, 3, uint.MaxValue, TimeSpan.FromTicks(-1)));
        Assert.StartsWith("12.345,3,4294967295,-0.0000001,1.5,-0.001,0.00000001,0,0,0,1,", Lines(text)[1], StringComparison.Ordinal);
    }

    [Fact]
    public void Cultures_do_not_matter()
    {
        BoneTransform[] pose = Random(5);
        var options = new PoseCsvOptions { FrameRate = 59.94, StartTime = new DateTimeOffset(2026, 5, 1, 12, 0, 0, TimeSpan.FromHours(2)) };
        string expected = Write(writer => writer.WriteRow(TimeSpan.FromSeconds(1.5), pose, 1, 2), options);
        CultureInfo culture = CultureInfo.CurrentCulture;
        try
        {
            var other = (CultureInfo)CultureInfo.InvariantCulture.Clone();
            (other.NumberFormat.NumberDecimalSeparator, other.NumberFormat.NegativeSign, other.DateTimeFormat.TimeSeparator) = (",", "~", ".");
            CultureInfo.CurrentCulture = other;
            Assert.Equal(expected, Write(writer => writer.WriteRow(TimeSpan.FromSeconds(1.5), pose, 1, 2), options));
        }
        finally
        {
            CultureInfo.CurrentCulture = culture;
        }

        Assert.Contains("# rate: 59.94 frames per second\n", expected, StringComparison.Ordinal);
        Assert.Contains("# start: 2026-05-01T10:00:00.000Z\n", expected, StringComparison.Ordinal);
    }

    [Fact]
    public void Values_that_are_not_finite_are_words_and_later_rows_are_right()
    {
        BoneTransform[] pose = Random(5);
        BoneTransform[] broken = [.. pose];
        broken[0] = new BoneTransform(new Vector3(float.NaN, float.PositiveInfinity, float.NegativeInfinity), new Quaternion(float.NaN, 0, 0, 1));
        string[] rows = Lines(Write(writer =>
        {
            writer.WriteRow(default, broken);
            writer.WriteRow(default, pose);
        }));
        Assert.StartsWith("0,0,,,NaN,Infinity,-Infinity,NaN,0,0,1,", rows[1], StringComparison.Ordinal);
        Assert.Equal(Lines(Write(writer => writer.WriteRow(default, pose)))[1], rows[2]);
    }

    [Fact]
    public void Quaternions_of_an_avatar_do_not_jump()
    {
        string[] rows = Lines(Write(static writer =>
        {
            for (int i = 0; i < 100; i++)
            {
                // Three full turns. The sender changes the sign at random, and another avatar turns the other way.
                var turned = Quaternion.CreateFromAxisAngle(Vector3.UnitY, i * 0.2f);
                writer.WriteRow(default, All(i % 3 == 0 ? -turned : turned));
                writer.WriteRow(default, All(Quaternion.Conjugate(turned)), avatarIndex: 1);
            }
        }));

        Quaternion[] read = [.. rows[1..].Where(static row => row.StartsWith("0,0,", StringComparison.Ordinal)).Select(static row => ReadRotation(row))];
        Assert.True(read[0].W >= 0);
        Assert.All(read.Zip(read.Skip(1)), static pair => Assert.InRange(Quaternion.Dot(pair.First, pair.Second), 0.99f, 1.01f));
    }

    [Fact]
    public void Every_line_but_comments_has_the_same_columns()
    {
        var options = new PoseCsvOptions
        {
            Variant = SkeletonVariant.Spine3,
            Source = "a\r\nb,c\u2028\"#.bvh",
            AvatarNames = new Dictionary<int, string> { [0] = "Zoë 😀\n0,0,0", [1] = "'" },
        };
        string text = Write(static writer => writer.WriteRow(default, All(Quaternion.Identity)), options);
        string[] lines = Lines(text);
        Assert.Equal(2, lines.Length);
        Assert.All(lines, static line => Assert.Equal(FirstBone + (59 * 7), line.Split(',').Length));
        Assert.Contains(",Spine3_qw,Neck_x,", lines[0], StringComparison.Ordinal);
        Assert.Contains("# source: a  b,c \"#.bvh\n", text, StringComparison.Ordinal);
        Assert.Contains("RightShoulder=Spine3", text, StringComparison.Ordinal);
        Assert.DoesNotContain('\r', text);
    }

    [Fact]
    public void Rows_need_no_new_memory()
    {
        BoneTransform[] pose = Random(5);
        using var writer = new PoseCsvWriter(Stream.Null);
        Allocations.AssertNone(() => writer.WriteRow(TimeSpan.FromSeconds(1), pose, 0, 1));
    }

    [Fact]
    public void Wrong_calls_are_refused()
    {
        using var stream = new MemoryStream();
        var writer = new PoseCsvWriter(stream, leaveOpen: true);
        Assert.Throws<ArgumentException>(() => writer.WriteRow(default, new BoneTransform[58]));
        writer.Dispose();
        writer.Dispose();
        Assert.Throws<ObjectDisposedException>(() => writer.WriteRow(default, Random(1)));
        Assert.True(stream.CanWrite);
        Assert.Equal(0, writer.RowCount);
    }

    private static string Write(Action<PoseCsvWriter> write, PoseCsvOptions? options = null)
    {
        using var stream = new MemoryStream();
        using (var writer = new PoseCsvWriter(stream, options, leaveOpen: true))
            write(writer);

        return Encoding.UTF8.GetString(stream.ToArray());
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_writer_that_cannot_begin_closes_its_stream(bool leaveOpen)
    {
        using var stream = new FullStream();
        Assert.Throws<IOException>(() => new PoseCsvWriter(stream, leaveOpen: leaveOpen));
        Assert.Equal(leaveOpen, stream.CanWrite);
    }

    private sealed class FullStream : MemoryStream
    {
        public override void Write(byte[] buffer, int offset, int count) => throw new IOException("No space left on device");
    }

    private static string[] Lines(string text) =>
        [.. text.Split('\n').Where(static line => line.Length > 0 && line[0] != '#')];

    private static float Parse(string text) => float.Parse(text, CultureInfo.InvariantCulture);

    private static Quaternion ReadRotation(string row)
    {
        float[] values = [.. row.Split(',')[(FirstBone + 3)..(FirstBone + 7)].Select(Parse)];
        return new Quaternion(values[0], values[1], values[2], values[3]);
    }

    private static BoneTransform[] All(Quaternion rotation) =>
        [.. Enumerable.Repeat(new BoneTransform(Vector3.One, rotation), BoneHierarchy.BoneCount)];

    private static BoneTransform[] Random(int seed)
    {
        var random = new Random(seed);
        float Next() => ((float)random.NextDouble() - 0.5f) * 400;
        return
        [
            .. Enumerable.Range(0, BoneHierarchy.BoneCount).Select(_ =>
            {
                var rotation = Quaternion.Normalize(new Quaternion(Next(), Next(), Next(), Next()));
                return new BoneTransform(new Vector3(Next(), Next(), Next()), rotation.W < 0 ? -rotation : rotation);
            }),
        ];
    }
}
