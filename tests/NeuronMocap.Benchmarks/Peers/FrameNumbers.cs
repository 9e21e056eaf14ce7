using System.Buffers.Binary;

namespace NeuronMocap.Benchmarks.Peers;

// Reads the frame numbers in a stream of whole frames, however it is split, and counts the missing ones.
internal sealed class FrameNumbers
{
    private readonly byte[] _number = new byte[sizeof(uint)];
    private long _position;

    // The number of the newest frame, or -1.
    public long Last { get; private set; } = -1;

    // Number of frames that are missing between others.
    public long Missing { get; private set; }

    public void Read(ReadOnlySpan<byte> bytes)
    {
        int at = 0;
        while (at < bytes.Length)
        {
            int place = (int)((_position + at) % TestFrame.Size) - TestFrame.IndexOffset;
            if (place is >= 0 and < sizeof(uint))
            {
                _number[place] = bytes[at++];
                if (place == sizeof(uint) - 1)
                    Take(BinaryPrimitives.ReadUInt32LittleEndian(_number));
            }
            else
            {
                at += place < 0 ? -place : TestFrame.Size - place;
            }
        }

        _position += bytes.Length;
    }

    // A sender that repeats a number does not number its frames.
    private void Take(uint number)
    {
        if (Last >= 0 && number > Last)
            Missing += number - Last - 1;

        Last = number;
    }
}
