using NeuronMocap.Calculation;
using NeuronMocap.Csv;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Calculation;

namespace NeuronMocap.Tests.Files;

// What a full disk leaves of a table: the beginning of the whole file.
public sealed class TableFullDiskTests
{
    private const int Rows = 200;
    private const int FullAt = 100_000;

    [Theory]
    [InlineData(true, true)]
    [InlineData(true, false)]
    [InlineData(false, true)]
    [InlineData(false, false)]
    public void A_table_ends_where_the_disk_is_full(bool isPoses, bool isFullOnce)
    {
        var whole = new Disk(int.MaxValue, isFullOnce: false);
        using (ITable table = Begin(isPoses, whole))
        {
            for (int row = 0; row < Rows; row++)
                table.WriteRow(row);
        }

        var disk = new Disk(FullAt, isFullOnce);
        using (ITable table = Begin(isPoses, disk))
        {
            for (int row = 0; row < Rows; row++)
            {
                Exception? failure = Record.Exception(() => table.WriteRow(row));
                Assert.Equal(disk.HasFailed ? typeof(IOException) : null, failure?.GetType());
            }

            Assert.True(disk.HasFailed);
            Assert.Throws<IOException>(table.Flush);
        }

        Assert.Equal(whole.ToArray()[..FullAt], disk.ToArray());
        Assert.False(disk.CanWrite);
    }

    // The end of the last row does not follow a row that failed.
    [Fact]
    public void A_row_is_not_ended_after_a_failure()
    {
        var format = CalculationTextFormat.AxisNeuron with { LastRowEnd = "\n" };
        var disk = new Disk(FullAt, isFullOnce: true);
        var writer = new CalculationFileWriter(disk, CalculationFrame.FullValueCount, format);
        Assert.Throws<IOException>(() =>
        {
            for (int row = 0; row < Rows; row++)
                writer.WriteFrame(CalculationText.Values(0));
        });
        writer.Dispose();
        Assert.Equal(FullAt, disk.ToArray().Length);
    }

    private static ITable Begin(bool isPoses, Stream stream) => isPoses ? new PoseTable(stream) : new CalculationTable(stream);

    private interface ITable : IDisposable
    {
        void WriteRow(int row);

        void Flush();
    }

    private sealed class PoseTable(Stream stream) : ITable
    {
        private readonly PoseCsvWriter _writer = new(stream);

        public void WriteRow(int row) => _writer.WriteRow(TimeSpan.FromSeconds(row), new BoneTransform[BoneHierarchy.BoneCount]);

        public void Flush() => _writer.Flush();

        public void Dispose() => _writer.Dispose();
    }

    private sealed class CalculationTable(Stream stream) : ITable
    {
        private readonly CalculationFileWriter _writer = new(stream, CalculationFrame.FullValueCount);

        public void WriteRow(int row) => _writer.WriteFrame(CalculationText.Values(row));

        public void Flush() => _writer.Flush();

        public void Dispose() => _writer.Dispose();
    }

    // Takes what fits, and fails from then on, or once.
    private sealed class Disk(int room, bool isFullOnce) : MemoryStream
    {
        public bool HasFailed { get; private set; }

        public override void Write(byte[] buffer, int offset, int count)
        {
            int taken = HasFailed && isFullOnce ? count : Math.Min(count, room - (int)Position);
            base.Write(buffer, offset, taken);
            if (taken == count)
                return;

            HasFailed = true;
            throw new IOException("No space left on device.");
        }
    }
}
