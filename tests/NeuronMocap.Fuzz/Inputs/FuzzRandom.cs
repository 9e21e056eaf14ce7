using System.Numerics;

namespace NeuronMocap.Fuzz.Inputs;

/// <summary>SplitMix64: the same numbers on every machine. Setting the seed for each input costs nothing.</summary>
internal struct FuzzRandom(ulong seed)
{
    private ulong _state = seed;

    public ulong Next()
    {
        _state += 0x9E3779B97F4A7C15;
        ulong mixed = (_state ^ (_state >> 30)) * 0xBF58476D1CE4E5B9;
        mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EB;
        return mixed ^ (mixed >> 31);
    }

    /// <summary>Returns a number from 0 to below the limit, which is at least 1.</summary>
    public int Below(int limit) => (int)(((Next() >> 32) * (ulong)limit) >> 32);

    /// <summary>Returns a number between two bounds, both included.</summary>
    public int Between(int least, int most) => least + Below(most - least + 1);

    /// <summary>Returns mostly small numbers: each doubling up to the limit is equally likely.</summary>
    public int Small(int limit) => Below(Math.Min(limit, 1 << Between(1, BitOperations.Log2((uint)limit) + 1)));

    public T Choose<T>(IReadOnlyList<T> list) => list[Below(list.Count)];
}
