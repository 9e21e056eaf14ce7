using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Plot;

namespace NeuronMocap.Tool.Tests.Plot;

public sealed class SvgDrawingTests
{
    private const int DiskFull = 28;

    [Fact]
    public void A_full_disk_is_the_fault_that_arrives()
    {
        using var disk = new FullDisk();
        var exception = Assert.Throws<IOException>(() =>
        {
            using var svg = new SvgDrawing(disk, 100, 100, "take.bvh");
            for (int i = 0; i < 1000; i++)
                svg.Line(0, 0, i, i, PlotTheme.Ink);
        });
        Assert.Equal("'take.svg': the disk is full.", FileFault.OfWriting(exception, "take.svg"));
    }

    private sealed class FullDisk : MemoryStream
    {
        public override void Write(byte[] buffer, int offset, int count) => throw new IOException("No space left on device", DiskFull);
    }
}
