using System.Runtime.InteropServices;

namespace NeuronMocap.Gltf;

// A list of any length of which only the end is in memory. glTF files are little-endian, as are all processors that .NET and Unity run on.
internal sealed class FloatList(KeySpool spool)
{
    private const int FirstCapacity = 64;
    private const int Capacity = 4096;

    private readonly List<Piece> _pieces = [];
    private float[] _open = [];
    private int _length;

    public long Count { get; private set; }

    public void Add(float value)
    {
        if (_length == Capacity)
            Close();
        if (_length == _open.Length)
            Array.Resize(ref _open, Math.Max(FirstCapacity, 2 * _open.Length));

        _open[_length++] = value;
        Count++;
        spool.Promised += sizeof(float);
    }

    public void Add(ReadOnlySpan<float> values)
    {
        foreach (float value in values)
            Add(value);
    }

    // Takes no more memory than adding it once.
    public void AddRepeated(ReadOnlySpan<float> values, long times)
    {
        Close();
        Add(values);
        Close(times);
        Count += values.Length * (times - 1);
        spool.Promised += values.Length * (times - 1) * sizeof(float);
    }

    public void CopyTo(Stream output)
    {
        byte[] bytes = new byte[Capacity * sizeof(float)];
        foreach (Piece piece in _pieces)
        {
            spool.Read(piece.Place, bytes, piece.Bytes);
            for (long i = 0; i < piece.Times; i++)
                output.Write(bytes, 0, piece.Bytes);
        }

        output.Write(bytes, 0, Fill(bytes));
    }

    private void Close(long times = 1)
    {
        if (_length == 0)
            return;

        byte[] bytes = new byte[_length * sizeof(float)];
        _pieces.Add(new Piece(spool.Append(bytes, Fill(bytes)), bytes.Length, times));
        _length = 0;
    }

    private int Fill(byte[] bytes)
    {
        ReadOnlySpan<byte> open = MemoryMarshal.AsBytes(_open.AsSpan(0, _length));
        open.CopyTo(bytes);
        return open.Length;
    }

    private readonly record struct Piece(long Place, int Bytes, long Times);
}
