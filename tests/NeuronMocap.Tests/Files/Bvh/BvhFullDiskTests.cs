using NeuronMocap.Bvh;
using NeuronMocap.Tests.Recording;

namespace NeuronMocap.Tests.Bvh;

// What a full disk leaves of a file.
public sealed class BvhFullDiskTests
{
    private const int Rows = 60;

    private static readonly BvhDocument TwoRows = BvhSamples.Parse(BvhSamples.TwoRows);

    [Fact]
    public void A_full_disk_keeps_the_reported_rows()
    {
        using var whole = new MemoryStream();
        using (BvhWriter writer = Begin(whole))
            WriteRows(writer);

        int cut = 0;
        int length = whole.ToArray().Length;
        for (int room = 0; room < length; room += 7)
        {
            var disk = new FullStream(room);
            BvhWriter writer = Begin(disk);
            Assert.Throws<IOException>(() => WriteRows(writer));
            Assert.Throws<IOException>(writer.Flush);
            writer.Dispose();
            byte[] left = disk.ToArray();
            Assert.InRange(left.Length, 0, room);
            if (left.Length == 0)
            {
                Assert.Equal(0, writer.FrameCount);
                continue;
            }

            BvhDocument read = BvhDocument.Parse(left);
            Assert.DoesNotContain(read.Repairs, repair => !repair.Description.Contains("no frames", StringComparison.OrdinalIgnoreCase));
            Assert.Equal(writer.FrameCount, read.FrameCount);
            for (int frame = 0; frame < read.FrameCount; frame++)
                Assert.Equal(TwoRows.GetValues(frame % 2).ToArray(), read.GetValues(frame).ToArray());

            cut += read.FrameCount > 0 ? 1 : 0;
        }

        Assert.True(cut > 100);
    }

    private static BvhWriter Begin(Stream stream) => new(stream, TwoRows.Hierarchy, BvhFrameTime.Default);

    private static void WriteRows(BvhWriter writer)
    {
        for (int i = 0; i < Rows; i++)
        {
            writer.WriteFrame(TwoRows.GetValues(i % 2));
            if (i % 5 == 4)
                writer.Flush();
        }
    }
}
