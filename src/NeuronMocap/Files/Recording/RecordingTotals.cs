using System.Buffers.Binary;

namespace NeuronMocap.Recording;

/// <summary>The totals of a recording.</summary>
/// <param name="Pieces">Number of pieces: reads from the socket over TCP, datagrams over UDP.</param>
/// <param name="Bytes">Number of bytes in these pieces.</param>
/// <param name="LostPieces">Number of received pieces that are missing (<see cref="RecordingEntryKind.BytesLost"/>).</param>
/// <param name="LostBytes">Number of bytes in the missing pieces.</param>
public readonly record struct RecordingTotals(long Pieces, long Bytes, long LostPieces, long LostBytes);

// The payload of the last block.
internal readonly record struct RecordingEnd(long IndexOffset, long Duration, RecordingTotals Totals)
{
    public const int Size = 6 * sizeof(long);

    public void Write(Span<byte> destination)
    {
        ReadOnlySpan<long> values = [IndexOffset, Duration, Totals.Pieces, Totals.Bytes, Totals.LostPieces, Totals.LostBytes];
        for (int i = 0; i < values.Length; i++)
            BinaryPrimitives.WriteInt64LittleEndian(destination[(i * sizeof(long))..], values[i]);
    }

    public static RecordingEnd Read(ReadOnlySpan<byte> payload) => new(
        ReadValue(payload, 0),
        Math.Clamp(ReadValue(payload, 1), 0, RecordingLayout.MaxTime),
        new RecordingTotals(ReadValue(payload, 2), ReadValue(payload, 3), ReadValue(payload, 4), ReadValue(payload, 5)));

    private static long ReadValue(ReadOnlySpan<byte> payload, int index) => BinaryPrimitives.ReadInt64LittleEndian(payload[(index * sizeof(long))..]);
}
