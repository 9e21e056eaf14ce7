namespace NeuronMocap.Protocol;

// An unsigned integer in memory that the caller provides, lowest limb first. Overflow is discarded. BigInteger would allocate.
internal readonly ref struct WideInteger(Span<uint> limbs)
{
    private const int LimbBits = 32;

    private readonly Span<uint> _limbs = limbs;

    public bool IsZero
    {
        get
        {
            foreach (uint limb in _limbs)
            {
                if (limb != 0)
                    return false;
            }

            return true;
        }
    }

    public int BitLength
    {
        get
        {
            int length = _limbs.Length * LimbBits;
            while (length > 0 && !HasBit(length - 1))
                length--;

            return length;
        }
    }

    public void Set(uint value)
    {
        _limbs.Clear();
        _limbs[0] = value;
    }

    public void CopyTo(WideInteger other) => _limbs.CopyTo(other._limbs);

    public void Increment() => Add(1);

    public void Add(uint value)
    {
        ulong carry = value;
        for (int i = 0; i < _limbs.Length && carry != 0; i++)
        {
            carry += _limbs[i];
            _limbs[i] = (uint)carry;
            carry >>= LimbBits;
        }
    }

    public void Multiply(uint factor)
    {
        ulong carry = 0;
        foreach (ref uint limb in _limbs)
        {
            carry += (ulong)limb * factor;
            limb = (uint)carry;
            carry >>= LimbBits;
        }
    }

    /// <summary>Divides this number by the divisor.</summary>
    /// <returns>The remainder.</returns>
    public uint Divide(uint divisor)
    {
        ulong rest = 0;
        for (int i = _limbs.Length - 1; i >= 0; i--)
        {
            rest = (rest << LimbBits) | _limbs[i];
            _limbs[i] = (uint)(rest / divisor);
            rest %= divisor;
        }

        return (uint)rest;
    }

    public bool HasBit(int bit) => ((Limb(bit / LimbBits) >> (bit % LimbBits)) & 1) != 0;

    public void ShiftLeft(int bits)
    {
        (int limbs, int rest) = (bits / LimbBits, bits % LimbBits);
        for (int i = _limbs.Length - 1; i >= 0; i--)
        {
            ulong pair = ((ulong)Limb(i - limbs) << LimbBits) | Limb(i - limbs - 1);
            _limbs[i] = (uint)((pair << rest) >> LimbBits);
        }
    }

    public void ShiftRight(int bits)
    {
        (int limbs, int rest) = (bits / LimbBits, bits % LimbBits);
        for (int i = 0; i < _limbs.Length; i++)
            _limbs[i] = (uint)((((ulong)Limb(i + limbs + 1) << LimbBits) | Limb(i + limbs)) >> rest);
    }

    /// <summary>Subtracts a smaller number.</summary>
    public void Subtract(WideInteger other)
    {
        long carry = 0;
        for (int i = 0; i < _limbs.Length; i++)
        {
            carry += (long)_limbs[i] - other._limbs[i];
            _limbs[i] = (uint)carry;
            carry >>= LimbBits;
        }
    }

    public int CompareTo(WideInteger other)
    {
        for (int i = _limbs.Length - 1; i >= 0; i--)
        {
            if (_limbs[i] != other._limbs[i])
                return _limbs[i] > other._limbs[i] ? 1 : -1;
        }

        return 0;
    }

    private uint Limb(int index) => (uint)index < (uint)_limbs.Length ? _limbs[index] : 0;
}
