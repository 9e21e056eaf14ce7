using System.Text;
using FsCheck.Fluent;
using NeuronMocap.Bvh;
using static NeuronMocap.Tests.Bvh.BvhSamples;

namespace NeuronMocap.Tests.Bvh;

public sealed class BvhWriterTests : IDisposable
{
    private readonly string _path = Path.Combine(Path.GetTempPath(), $"neuronmocap-{Guid.NewGuid():N}.bvh");

    public void Dispose() => File.Delete(_path);

    [Fact]
    public void Any_document_is_read_back_with_the_same_values() =>
        Properties.Hold(Gen.Choose(0, int.MaxValue - 1), Properties.SimplerNumbers, count: 300, static seed =>
        {
            var random = new RandomTakes(seed);
            BvhHierarchy hierarchy = random.AnyHierarchy();
            var document = new BvhDocument(hierarchy, new BvhFrameTime(1001, 60_000), random.AnyValues(hierarchy.ChannelCount * 5))
            {
                TextFormat = random.AnyFormat(),
            };

            byte[] text = Saved(document);
            BvhDocument read = BvhDocument.Parse(text);

            Assert.DoesNotContain(read.Repairs, repair => !repair.Description.Contains("not finite", StringComparison.Ordinal));
            AssertSameHierarchy(hierarchy, read.Hierarchy);
            Assert.Equal(document.FrameTime, read.FrameTime);
            AssertSameValues(Values(document), Values(read));
            Assert.Equal(Encoding.UTF8.GetString(text), Encoding.UTF8.GetString(Saved(new BvhDocument(read.Hierarchy, read.FrameTime, Values(read)) { TextFormat = document.TextFormat })));
        });

    [Fact]
    public void Rows_written_one_by_one_read_back_with_padded_fields()
    {
        BvhDocument document = Parse(TwoRows);
        using (var writer = new BvhWriter(_path, document.Hierarchy, BvhFrameTime.Default))
        {
            writer.WriteFrame(document.GetValues(0));
            writer.WriteFrame(document.GetValues(1));
            Assert.Equal(2, writer.FrameCount);
        }

        BvhDocument read = BvhDocument.Load(_path);
        Assert.Empty(read.Repairs);
        AssertBits(Values(document), Values(read));
        Assert.Contains("\r\nFrames: 2         \r\nFrame Time: 0.008333            \r\n1.000000 2.0", File.ReadAllText(_path), StringComparison.Ordinal);
    }

    [Fact]
    public void Flushed_rows_are_in_the_file_with_their_count()
    {
        BvhDocument document = Parse(TwoRows);
        using var writer = new BvhWriter(_path, document.Hierarchy, BvhFrameTime.Default);
        writer.WriteFrame(document.GetValues(0));
        writer.Flush();
        writer.WriteFrame(document.GetValues(1));

        BvhDocument read = BvhDocument.Parse(ReadShared());
        Assert.Empty(read.Repairs);
        AssertBits(document.GetValues(0), Values(read));

        writer.Flush();
        AssertBits(Values(document), Values(BvhDocument.Parse(ReadShared())));
    }

    [Fact]
    public void The_frame_time_can_be_set_at_the_end()
    {
        BvhDocument document = Parse(TwoRows);
        using (var writer = new BvhWriter(_path, document.Hierarchy, BvhFrameTime.Default))
        {
            writer.WriteFrame(document.GetValues(0));
            writer.FrameTime = new BvhFrameTime(1001, 30_000);
        }

        Assert.Equal(new BvhFrameTime(1001, 30_000), BvhDocument.Load(_path).FrameTime);
    }

    // Some programs write 17 digits. The last of them must neither lack room nor stay behind another text.
    [Theory]
    [InlineData("0.0041666666666666666", 240)]
    [InlineData("0.0083333333333333332", 60)]
    public void A_long_text_of_the_frame_time_leaves_room_for_another(string text, int rate)
    {
        BvhDocument document = Parse(TwoRows);
        using var memory = new MemoryStream();
        using (var writer = new BvhWriter(memory, document.Hierarchy, BvhFrameTime.Default, new BvhTextFormat { FrameTimeText = text }, leaveOpen: true))
        {
            writer.WriteFrame(document.GetValues(0));
            writer.FrameTime = new BvhFrameTime(1, rate);
            writer.Flush();
        }

        BvhDocument read = BvhDocument.Parse(memory.ToArray());
        Assert.Empty(read.Repairs);
        Assert.Equal(new BvhFrameTime(1, rate), read.FrameTime);
        AssertBits(document.GetValues(0), Values(read));
    }

    [Fact]
    public void A_long_text_of_the_frame_time_is_kept()
    {
        BvhDocument document = Parse(TwoRows);
        using (var writer = new BvhWriter(_path, document.Hierarchy, BvhFrameTime.Default, new BvhTextFormat { FrameTimeText = "0.0083333333333333332" }))
        {
            writer.FrameTime = new BvhFrameTime(1, 60);
            writer.Flush();
            writer.FrameTime = BvhFrameTime.Default;
        }

        Assert.Contains("\r\nFrame Time: 0.0083333333333333332\r\n", File.ReadAllText(_path), StringComparison.Ordinal);
    }

    [Fact]
    public void An_unseekable_stream_gets_a_valid_file()
    {
        BvhDocument document = Parse(TwoRows);
        using var memory = new MemoryStream();
        using (var writer = new BvhWriter(new OneWayStream(memory), document.Hierarchy, BvhFrameTime.Default))
        {
            writer.WriteFrame(document.GetValues(0));
            Assert.Throws<InvalidOperationException>(() => writer.FrameTime = new BvhFrameTime(1, 60));
        }

        BvhDocument read = BvhDocument.Parse(memory.ToArray());
        Assert.Contains("The file declares '0' frames but has 1 row;", OnlyRepair(read).Description, StringComparison.Ordinal);
        AssertBits(document.GetValues(0), Values(read));
    }

    // If a stream already contains data, places are relative to the stream.
    [Fact]
    public void A_stream_is_written_from_its_position()
    {
        BvhDocument document = Parse(TwoRows);
        using var memory = new MemoryStream();
        memory.Write("some text before HIERARCHY, "u8);
        using (var writer = new BvhWriter(memory, document.Hierarchy, BvhFrameTime.Default, leaveOpen: true))
            writer.WriteFrame(document.GetValues(0));

        Assert.Equal(memory.Length, memory.Position);
        Assert.StartsWith("some text before HIERARCHY, HIERARCHY", Encoding.ASCII.GetString(memory.ToArray()), StringComparison.Ordinal);
        Assert.Contains("Frames: 1 ", Encoding.ASCII.GetString(memory.ToArray()), StringComparison.Ordinal);
    }

    // CHANNELS may come after the children's. The values of a row follow the order of these lines.
    [Fact]
    public void Columns_in_another_order_are_written_in_joint_order()
    {
        BvhDocument document = Parse(
            "HIERARCHY\nROOT A\n{\nOFFSET 0 0 0\nJOINT B\n{\nOFFSET 1 0 0\nCHANNELS 1 Xrotation\n}\nCHANNELS 2 Yrotation Zrotation\n}\n"
            + "MOTION\nFrames: 1\nFrame Time: 0.01\n1 2 3\n");

        BvhDocument read = BvhDocument.Parse(Saved(document));
        Assert.Equal([2f, 3, 1], Values(read));
        Assert.Equal(["Yrotation", "Zrotation"], read.Joints[0].Channels.Select(channel => channel.ToString()));
    }

    [Fact]
    public void Unnamed_joints_and_unknown_channels_are_kept()
    {
        BvhDocument document = Parse(
            "HIERARCHY\nROOT\n{\nOFFSET 0 0 0\nCHANNELS 2 Xrotation Scale\n}\nMOTION\nFrames: 1\nFrame Time: 0.01\n1 2\n");

        BvhDocument read = BvhDocument.Parse(Saved(document));
        AssertSameHierarchy(document.Hierarchy, read.Hierarchy);
        AssertBits(Values(document), Values(read));
    }

    [Fact]
    public void A_row_allocates_nothing()
    {
        BvhHierarchy hierarchy = BvhBoneHierarchy.Create(default, default);
        float[] row = [.. Enumerable.Range(0, 180).Select(i => (i / 7f) - 10)];
        row[5] = float.Epsilon;
        row[6] = float.NaN;
        using var writer = new BvhWriter(_path, hierarchy, BvhFrameTime.Default);
        Allocations.AssertNone(() => writer.WriteFrame(row));
    }

    [Fact]
    public void Wrong_arguments_are_refused()
    {
        BvhHierarchy hierarchy = Parse(TwoRows).Hierarchy;
        Assert.Throws<ArgumentException>(() => new BvhWriter(new MemoryStream(), hierarchy, default));
        Assert.Throws<ArgumentException>(() => new BvhWriter(new MemoryStream([], writable: false), hierarchy, BvhFrameTime.Default));
        var writer = new BvhWriter(new MemoryStream(), hierarchy, BvhFrameTime.Default);
        Assert.Throws<ArgumentException>(() => writer.WriteFrame(new float[8]));
        Assert.Throws<ArgumentException>(() => writer.FrameTime = default);
        writer.Dispose();
        writer.Dispose();
        Assert.Throws<ObjectDisposedException>(() => writer.WriteFrame(new float[9]));
        Assert.Throws<ObjectDisposedException>(writer.Flush);
    }

    internal static byte[] Saved(BvhDocument document)
    {
        using var memory = new MemoryStream();
        document.Save(memory);
        return memory.ToArray();
    }

    private static void AssertSameHierarchy(BvhHierarchy expected, BvhHierarchy actual) => Assert.Equal(
        expected.Joints.Select(static joint => (joint.Name, joint.Parent?.Index, joint.Offset, joint.EndSite, joint.FirstChannel, string.Join(' ', joint.Channels))),
        actual.Joints.Select(static joint => (joint.Name, joint.Parent?.Index, joint.Offset, joint.EndSite, joint.FirstChannel, string.Join(' ', joint.Channels))));

    // Text does not distinguish the many patterns of NaN.
    private static void AssertSameValues(float[] expected, float[] actual) => AssertBits(
        [.. expected.Select(static value => float.IsNaN(value) ? float.NaN : value)],
        [.. actual.Select(static value => float.IsNaN(value) ? float.NaN : value)]);

    [Fact]
    public void A_file_is_not_emptied_by_wrong_arguments()
    {
        File.WriteAllText(_path, "precious");
        Assert.Throws<ArgumentException>(() => new BvhWriter(_path, Parse(Hierarchy).Hierarchy, default));
        Assert.Throws<ArgumentNullException>(() => new BvhWriter(_path, null!, BvhFrameTime.Default));
        Assert.Equal("precious", File.ReadAllText(_path));
    }

    private byte[] ReadShared()
    {
        using var stream = new FileStream(_path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite);
        byte[] bytes = new byte[stream.Length];
        stream.ReadExactly(bytes);
        return bytes;
    }

    private sealed class OneWayStream(Stream inner) : Stream
    {
        public override bool CanRead => false;

        public override bool CanSeek => false;

        public override bool CanWrite => true;

        public override long Length => throw new NotSupportedException();

        public override long Position
        {
            get => throw new NotSupportedException();
            set => throw new NotSupportedException();
        }

        public override void Flush() => inner.Flush();

        public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();

        public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

        public override void SetLength(long value) => throw new NotSupportedException();

        public override void Write(byte[] buffer, int offset, int count) => inner.Write(buffer, offset, count);
    }
}
