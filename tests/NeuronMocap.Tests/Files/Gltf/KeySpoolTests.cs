using NeuronMocap.Gltf;

namespace NeuronMocap.Tests.Gltf;

public sealed class KeySpoolTests
{
    private static readonly byte[] Keys = new byte[1000];

    [Fact]
    public void A_disk_that_is_full_at_once_names_the_folder_and_the_file_is_closed()
    {
        var file = new FullFile(room: 0);
        using var spool = new KeySpool(memory: 1500, createFile: () => file);
        spool.Append(Keys, Keys.Length);
        var exception = Assert.Throws<IOException>(() => spool.Append(Keys, Keys.Length));

        Assert.Contains($"'{Path.GetTempPath()}'", exception.Message, StringComparison.Ordinal);
        Assert.Equal("No space left on device", exception.InnerException?.Message);
        Assert.True(file.IsClosed);
        Assert.False(spool.IsFile);
    }

    [Fact]
    public void A_disk_that_is_full_later_names_the_folder_and_closing_tells_nothing_more()
    {
        var file = new FullFile(room: 5000);
        using (var spool = new KeySpool(memory: 1500, createFile: () => file))
        {
            var exception = Assert.Throws<IOException>(() =>
            {
                for (int i = 0; i < 10; i++)
                    spool.Append(Keys, Keys.Length);
            });
            Assert.Contains($"'{Path.GetTempPath()}'", exception.Message, StringComparison.Ordinal);
        }

        Assert.True(file.IsClosed);
    }

    [Theory]
    [InlineData(typeof(UnauthorizedAccessException))]
    [InlineData(typeof(DirectoryNotFoundException))]
    [InlineData(typeof(ArgumentOutOfRangeException))]
    public void A_folder_that_takes_no_file_is_named(Type reason)
    {
        using var spool = new KeySpool(memory: 0, createFile: () => throw (Exception)Activator.CreateInstance(reason)!);
        Assert.Contains($"'{Path.GetTempPath()}'", Assert.Throws<IOException>(() => spool.Append(Keys, Keys.Length)).Message, StringComparison.Ordinal);
    }

    // Like a file with a buffer, it also fails when it is closed.
    private sealed class FullFile(int room) : Stream
    {
        private int _length;

        public bool IsClosed { get; private set; }

        public override bool CanRead => true;

        public override bool CanSeek => true;

        public override bool CanWrite => true;

        public override long Length => _length;

        public override long Position { get; set; }

        public override void Write(byte[] buffer, int offset, int count)
        {
            if (_length + count > room)
                throw NoSpace();

            _length += count;
        }

        public override int Read(byte[] buffer, int offset, int count) => 0;

        public override long Seek(long offset, SeekOrigin origin) => _length;

        public override void SetLength(long value) => throw new NotSupportedException();

        public override void Flush() => throw NoSpace();

        protected override void Dispose(bool disposing)
        {
            IsClosed = true;
            base.Dispose(disposing);
            throw NoSpace();
        }

        private static IOException NoSpace() => new("No space left on device", 28);
    }
}
