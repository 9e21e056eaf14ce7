using System.Text;

namespace NeuronMocap.Diagnostics;

internal static class BannerText
{
    private const int Longest = 60;

    // Returns the first line of a program's output if it is readable; otherwise null.
    public static string? Of(ReadOnlySpan<byte> bytes)
    {
        int end = bytes.IndexOfAny((byte)'\r', (byte)'\n');
        ReadOnlySpan<byte> line = end < 0 ? bytes : bytes[..end];
        foreach (byte value in line)
        {
            if (value is < 0x20 or > 0x7E)
                return null;
        }

        if (line.Length < 3)
            return null;

        string text = Encoding.ASCII.GetString(line[..Math.Min(line.Length, Longest)]);
        return line.Length > Longest ? text + "…" : text;
    }
}
