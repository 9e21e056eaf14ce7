using System.Diagnostics;
using System.Runtime.InteropServices;

namespace NeuronMocap.Benchmarks.Peers;

// The least that a recording on another thread needs: one thread copies frames into a ring, and another one copies them out. The ring is as large as that of a
// recording by default. The reader waits for an eighth of it, or a millisecond, in a spin, so nothing wakes it. If it followed each frame, the two processors
// would take the cache lines from each other, and a frame would cost several times as much.
internal sealed class BareRing : IDisposable
{
    private const int Room = 1536;
    private const int Size = 8 << 20;
    private const int Part = Size / Room / 8;
    private static readonly long LongestWait = Stopwatch.Frequency / 1000;

    private readonly byte[] _bytes = new byte[Size];
    private readonly Thread _reader;
    private Counts _counts;
    private volatile bool _stopping;

    public BareRing()
    {
        _reader = new Thread(Read) { IsBackground = true };
        _reader.Start();
    }

    public long FramesRead => Volatile.Read(ref _counts.Read);

    // The caller leaves no more frames unread than there is room for.
    public void Write(ReadOnlySpan<byte> frame)
    {
        frame.CopyTo(At(_counts.Written));
        Volatile.Write(ref _counts.Written, _counts.Written + 1);
    }

    public void Dispose()
    {
        _stopping = true;
        _reader.Join();
    }

    private void Read()
    {
        byte[] frame = new byte[TestFrame.Size];
        long looked = 0;
        while (!_stopping)
        {
            Thread.SpinWait(100);
            long written = Volatile.Read(ref _counts.Written);
            if (written - _counts.Read < Part && Stopwatch.GetTimestamp() - looked < LongestWait)
                continue;

            looked = Stopwatch.GetTimestamp();
            for (long next = _counts.Read; next < written; next++)
                At(next)[..TestFrame.Size].CopyTo(frame);

            Volatile.Write(ref _counts.Read, written);
        }
    }

    private Span<byte> At(long frame) => _bytes.AsSpan((int)(frame % (_bytes.Length / Room)) * Room, Room);

    // Far apart, so the two threads do not share a cache line.
    [StructLayout(LayoutKind.Explicit, Size = 384)]
    private struct Counts
    {
        [FieldOffset(128)]
        public long Written;

        [FieldOffset(256)]
        public long Read;
    }
}
