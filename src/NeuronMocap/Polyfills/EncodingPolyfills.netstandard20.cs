using System.Text;

namespace NeuronMocap.Polyfills;

// Conversions between spans and text. They copy: programs read names and messages this way, never frames.
internal static class EncodingPolyfills
{
    public static string GetString(this Encoding encoding, ReadOnlySpan<byte> bytes) => encoding.GetString(bytes.ToArray());

    public static int GetByteCount(this Encoding encoding, ReadOnlySpan<char> text) => encoding.GetByteCount(text.ToArray());

    public static int GetBytes(this Encoding encoding, string text, Span<byte> destination)
    {
        byte[] bytes = encoding.GetBytes(text);
        bytes.CopyTo(destination);
        return bytes.Length;
    }

    public static void Convert(
        this Encoder encoder, string text, Span<byte> destination, bool flush, out int charsUsed, out int bytesUsed, out bool isCompleted)
    {
        byte[] bytes = new byte[destination.Length];
        encoder.Convert(text.ToCharArray(), 0, text.Length, bytes, 0, bytes.Length, flush, out charsUsed, out bytesUsed, out isCompleted);
        bytes.AsSpan(0, bytesUsed).CopyTo(destination);
    }
}
