using System.Text;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// Says what bytes that are no packets probably are, and which setting makes them packets.
internal static class FormatGuess
{
    public static string Describe(ReadOnlySpan<byte> start, SkipReason reason)
    {
        if (reason == SkipReason.UnknownVersion && start.Length >= 6)
            return $"of data version {DataVersion.Read(start[2..])}, which this reader does not know: only 1.0 and 1.1 are";
        if (reason == SkipReason.TooLarge)
            return "a packet that announces more values than the limit allows. Raise MaxValues if that is right";
        if (reason == SkipReason.Incomplete)
            return "only the first part of each packet; the rest is lost on the way. Check the firewall, or use TCP";
        if (start.StartsWith("HTTP/"u8))
            return "a web server's answer. Check the port; Axis Neuron's default is 7001";
        if (start.Length >= 2 && start[0] == 0xCF && start[1] == 0xDC)
            return "Axis Studio's calculation data, which this reader does not read. Broadcast BVH data to this port";
        if (IsNumericText(start))
            return "text. In the server's broadcasting settings set the format (block type) to Binary";

        return $"of no format known here; it starts with {ToHex(start)}. Check the port, and that the server's format is Binary";
    }

    // "0 Char00 0.00 93.02": avatar number, name, numbers (protocol.md section 8).
    private static bool IsNumericText(ReadOnlySpan<byte> start)
    {
        bool digit = false;
        foreach (byte value in start)
        {
            if (value is < 0x20 and not ((byte)'\r' or (byte)'\n' or (byte)'\t' or 0))
                return false;

            digit |= value is >= (byte)'0' and <= (byte)'9';
        }

        return digit;
    }

    private static string ToHex(ReadOnlySpan<byte> bytes)
    {
        var text = new StringBuilder(bytes.Length * 3);
        foreach (byte value in bytes[..Math.Min(bytes.Length, 8)])
            text.Append(text.Length > 0 ? " " : string.Empty).Append(value.ToString("X2", provider: null));

        return text.ToString();
    }
}
