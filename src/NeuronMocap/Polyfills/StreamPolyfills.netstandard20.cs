using System.Buffers;

namespace NeuronMocap.Polyfills;

// Reads and writes of spans, through a rented array.
internal static class StreamPolyfills
{
    public static int Read(this Stream stream, Span<byte> destination)
    {
        byte[] bytes = ArrayPool<byte>.Shared.Rent(destination.Length);
        try
        {
            int count = stream.Read(bytes, 0, destination.Length);
            bytes.AsSpan(0, count).CopyTo(destination);
            return count;
        }
        finally
        {
            ArrayPool<byte>.Shared.Return(bytes);
        }
    }

    public static void Write(this Stream stream, ReadOnlySpan<byte> source)
    {
        byte[] bytes = ArrayPool<byte>.Shared.Rent(source.Length);
        try
        {
            source.CopyTo(bytes);
            stream.Write(bytes, 0, source.Length);
        }
        finally
        {
            ArrayPool<byte>.Shared.Return(bytes);
        }
    }
}
