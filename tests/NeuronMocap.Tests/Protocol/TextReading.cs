using System.Runtime.InteropServices;
using System.Text;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Protocol;

/// <summary>Lines of text, and their results from <see cref="PacketAssembler"/>.</summary>
internal static class TextReading
{
    public static string Line(int frame, int count, string end, string? lead = null, string separator = " ") =>
        Encoding.UTF8.GetString(TestPackets.Line(frame, count: count, lead: lead, separator: separator, end: end));

    public static PacketLog Read(string text) => Read(Encoding.UTF8.GetBytes(text));

    // Whole, and byte by byte. Both must give the same result.
    public static PacketLog Read(byte[] bytes)
    {
        PacketLog whole = Push([bytes]);
        PacketLog dripping = Push(bytes.Select(value => (byte[])[value]));
        Same.Packets(whole.Packets.Select(packet => packet.Bytes), dripping.Packets.Select(packet => packet.Bytes));
        Assert.Equal((whole.Skipped, whole.Text), (dripping.Skipped, dripping.Text));
        return whole;
    }

    private static PacketLog Push(IEnumerable<byte[]> pieces)
    {
        var log = new PacketLog();
        var assembler = new PacketAssembler(new PacketScanner(), log);
        foreach (byte[] piece in pieces)
            assembler.Push(piece, timestamp: 0);

        return log;
    }

    public static float[] ValuesOf(byte[] packet) => MemoryMarshal.Cast<byte, float>(packet.AsSpan(64)).ToArray();
}
