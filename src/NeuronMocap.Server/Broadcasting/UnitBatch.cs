namespace NeuronMocap.Server.Broadcasting;

/// <summary>Units that arrived together, one behind the other in memory. Does not allocate once its buffers have grown. Not thread-safe.</summary>
internal sealed class UnitBatch(int capacity = 64 * 1024)
{
    private readonly List<Unit> _units = [];
    private int _length;

    /// <summary>The bytes of all units.</summary>
    public byte[] Bytes { get; private set; } = new byte[capacity];

    /// <summary>Number of units that are complete.</summary>
    public int Count => _units.Count;

    /// <summary>Number of bytes after the last unit, which belong to the next unit.</summary>
    public int Rest => _length - Start;

    private int Start => EndOf(_units.Count - 1);

    /// <summary>Where a unit starts in <see cref="Bytes"/>.</summary>
    public int StartOf(int index) => EndOf(index - 1);

    /// <summary>Where a unit ends in <see cref="Bytes"/>.</summary>
    public int EndOf(int index) => index < 0 ? 0 : _units[index].End;

    public TimeSpan TimeOf(int index) => _units[index].Time;

    public bool IsCalculation(int index) => _units[index].IsCalculation;

    public ReadOnlySpan<byte> BytesOf(int index) => Bytes.AsSpan(StartOf(index), EndOf(index) - StartOf(index));

    /// <summary>Adds bytes to the next unit.</summary>
    public void Append(ReadOnlySpan<byte> bytes)
    {
        if (Bytes.Length - _length < bytes.Length)
        {
            byte[] larger = new byte[Math.Max(_length + bytes.Length, 2 * Bytes.Length)];
            Bytes.AsSpan(0, _length).CopyTo(larger);
            Bytes = larger;
        }

        bytes.CopyTo(Bytes.AsSpan(_length));
        _length += bytes.Length;
    }

    /// <summary>Replaces all units by one that is already in <see cref="Bytes"/>.</summary>
    /// <param name="length">Number of bytes, from the start.</param>
    public void SetSingle(int length)
    {
        _units.Clear();
        _length = length;
        Cut(TimeSpan.Zero, isCalculation: false);
    }

    /// <summary>Completes the next unit.</summary>
    public void Cut(TimeSpan time, bool isCalculation) => _units.Add(new Unit(_length, time, isCalculation));

    /// <summary>Makes the bytes after the last unit a part of that unit.</summary>
    public void ExtendLast() => _units[^1] = _units[^1] with { End = _length };

    /// <summary>Removes all units. Bytes after the last unit stay.</summary>
    public void RemoveUnits()
    {
        int start = Start;
        Bytes.AsSpan(start, _length - start).CopyTo(Bytes);
        _length -= start;
        _units.Clear();
    }

    private readonly record struct Unit(int End, TimeSpan Time, bool IsCalculation);
}
