namespace NeuronMocap.Recording;

internal static class StreamReads
{
    // Reads until the span is full or the stream ends, and returns the number of bytes read.
    public static int Fill(Stream stream, Span<byte> destination)
    {
        int filled = 0;
        while (filled < destination.Length)
        {
            int count = stream.Read(destination[filled..]);
            if (count == 0)
                break;

            filled += count;
        }

        return filled;
    }
}
