using System.Text;

namespace NeuronMocap.Fuzz.Inputs;

/// <summary>Small files of every kind that the file tools read.</summary>
internal static class FileFixtures
{
    public static IReadOnlyList<byte[]> Words { get; } = [.. BvhFixtures.Words, .. RecordingFixtures.Words, .. PacketFixtures.Words];

    public static IReadOnlyList<byte[]> Create()
    {
        byte[][] packets = [.. PacketFixtures.Create()];
        byte[][] lines = [.. TextFixtures.Create()];
        return
        [
            .. BvhFixtures.Create(),
            .. CalculationFixtures.Create(),
            .. RecordingFixtures.Create(),
            [.. packets[0], .. packets[1], .. packets[0]],
            [.. packets[7], .. packets[8], .. packets[8]],
            [.. packets[10], .. packets[10]],
            [.. packets[1], .. packets[14], .. packets[17], .. packets[9]],
            [.. lines[0], .. lines[1]],
            [.. lines[6], .. lines[6]],
            Encoding.ASCII.GetBytes("0 Char00 1 2 3||\n"),
        ];
    }
}
