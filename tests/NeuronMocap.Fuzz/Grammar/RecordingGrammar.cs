using System.Buffers.Binary;
using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Recording;

namespace NeuronMocap.Fuzz.Grammar;

/// <summary>Blocks of a recording, and the fields of their headers. The reading target corrects the checksums.</summary>
internal sealed class RecordingGrammar : IGrammar
{
    // Kind, sequence, length and time; encoding.
    private static readonly Part[] Fields = [new(4, 1), new(5, 1), new(8, 4), new(12, 4), new(16, 8), new(16, 4)];

    public IReadOnlyList<byte[]> Extremes { get; } =
    [
        .. ((long[])[0, 1, 2, 3, 4, 5, 31, 32, 33, 64, 255, 256, 1 << 16, 1 << 20, (1 << 20) + 1, int.MaxValue, 1L << 32, 1L << 59, 1L << 60, (1L << 60) + 1, long.MaxValue, -1])
            .Select(BitConverter.GetBytes),
    ];

    public void Split(ReadOnlySpan<byte> input, ref FuzzRandom random, List<Part> parts)
    {
        int start = RecordingLayout.FileHeaderSize;
        while (start < input.Length && input[start..].IndexOf(BlockHeader.Marker) is >= 0 and var found)
        {
            start += found;
            int length = RecordingLayout.BlockHeaderSize;
            if (input.Length - start >= length)
                length += Math.Max(0, BinaryPrimitives.ReadInt32LittleEndian(input[(start + 12)..]));

            length = Math.Min(Math.Max(length, RecordingLayout.BlockHeaderSize), input.Length - start);
            parts.Add(new Part(start, length));
            start += length;
        }
    }

    public void FindNumbers(ReadOnlySpan<byte> input, ref FuzzRandom random, List<Part> numbers)
    {
        Split(input, ref random, numbers);
        for (int i = 0; i < numbers.Count; i++)
        {
            Part field = random.Choose(Fields);
            int start = numbers[i].Start + field.Start;
            numbers[i] = new Part(start, Math.Max(0, Math.Min(field.Length, input.Length - start)));
        }
    }
}
