namespace NeuronMocap.Polyfills;

// Members of arrays, segments and other types of bytes that netstandard2.0 lacks.
internal static class MemoryPolyfills
{
    extension(Array)
    {
        public static void Fill<T>(T[] array, T value) => array.AsSpan().Fill(value);
    }

    public static ArraySegment<T> Slice<T>(this ArraySegment<T> segment, int index) =>
        new(segment.Array!, segment.Offset + index, segment.Count - index);

    public static ArraySegment<T> Slice<T>(this ArraySegment<T> segment, int index, int count) =>
        count <= segment.Count - index ? new(segment.Array!, segment.Offset + index, count) : throw new ArgumentOutOfRangeException(nameof(count));

    public static bool TryWriteBytes(this Guid guid, Span<byte> destination) => guid.ToByteArray().AsSpan().TryCopyTo(destination);
}
