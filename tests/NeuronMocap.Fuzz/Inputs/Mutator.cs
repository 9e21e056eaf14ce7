namespace NeuronMocap.Fuzz.Inputs;

/// <summary>Makes inputs out of a corpus: input number n of a seed is always the same.</summary>
internal sealed class Mutator(Corpus corpus, ulong seed)
{
    private const int MostMutations = 12;

    // Where the fields of packet headers begin; of use at such a distance from a token only.
    private static readonly int[] FieldOffsets = [2, 4, 5, 6, 8, 9, 10, 14, 18, 22, 46, 50, 54, 62];

    private static ReadOnlySpan<byte> Spaces => " \r\n\t"u8;

    private readonly byte[] _bytes = new byte[FuzzInput.MaxLength];
    private readonly byte[] _other = new byte[FuzzInput.MaxLength];
    private FuzzRandom _random;
    private int _length;

    /// <summary>Makes an input.</summary>
    /// <param name="number">Its number, from 0. The first ones are the fixtures as they are.</param>
    /// <returns>Valid until the next call.</returns>
    public ReadOnlySpan<byte> Make(long number)
    {
        _random = new FuzzRandom(seed ^ (ulong)number * 0xD6E8FEB86659FD93);
        _length = 0;
        if (number < corpus.Fixtures.Count)
        {
            Insert(0, corpus.Fixtures[(int)number]);
            return _bytes.AsSpan(0, _length);
        }

        for (int parts = _random.Below(3); parts >= 0; parts--)
            Insert(_length, _random.Choose(corpus.Fixtures));
        if (_random.Below(8) > 0)
            Keep(_random.Below(3) > 0 ? 0 : _random.Below(_length), 1 + _random.Below(1 << _random.Between(4, 13)));

        for (int changes = _random.Small(MostMutations); changes >= 0; changes--)
            Change();

        return _bytes.AsSpan(0, _length);
    }

    private void Change()
    {
        int at = _random.Below(_length + 1);
        int count = 1 + _random.Small(Math.Max(1, _length - at));
        switch (_random.Below(12))
        {
            case 0:
                Overwrite(at, [(byte)_random.Next()]);
                break;
            case 1 when at < _length:
                _bytes[at] ^= (byte)(1 << _random.Below(8));
                break;
            case 2:
                Overwrite(at, _random.Choose(corpus.Words));
                break;
            case 3:
                Insert(at, _random.Choose(corpus.Words));
                break;
            case 4:
                OverwriteField(at);
                break;
            case 5:
                Remove(at, count);
                break;
            case 6: // a stretch again, somewhere
                Insert(_random.Below(_length + 1), Copy(_bytes.AsSpan(0, _length), at, count));
                break;
            case 7: // a stretch of another fixture
                byte[] other = _random.Choose(corpus.Fixtures);
                Insert(at, Copy(other, _random.Below(other.Length), 1 + _random.Small(other.Length)));
                break;
            case 8: // one after the other, as often as fits
                Repeat(at, 1 + _random.Small(64), 1 + _random.Small(1_000));
                break;
            case 9: // the start of this one, the end of another
                byte[] end = _random.Choose(corpus.Fixtures);
                _length = at;
                Insert(at, end.AsSpan(_random.Below(end.Length)));
                break;
            case 10:
                _length = at;
                break;
            default:
                for (int i = 0; i < Math.Min(count, 16); i++)
                    Overwrite(at + i, [(byte)_random.Next()]);
                break;
        }
    }

    // A number at a field of the next header; where there is none, as in text, in place of the next word.
    private void OverwriteField(int at)
    {
        ReadOnlySpan<byte> rest = _bytes.AsSpan(at, _length - at);
        int token = rest.IndexOf((byte)0xFF);
        if (token >= 0)
        {
            Overwrite(at + token + _random.Choose(FieldOffsets), _random.Choose(corpus.Words));
            return;
        }

        int start = Math.Max(0, rest.IndexOfAny(Spaces) + 1);
        int length = rest[start..].IndexOfAny(Spaces);
        Remove(at + start, Math.Max(0, length));
        Insert(at + start, _random.Choose(corpus.Words));
    }

    private void Repeat(int at, int size, int times)
    {
        ReadOnlySpan<byte> stretch = Copy(_bytes.AsSpan(0, _length), at, size);
        int most = Math.Min(times, (FuzzInput.MaxLength - _length) / Math.Max(1, stretch.Length));
        for (int i = 0; i < most && _length < FuzzInput.MaxLength / 2; i++)
            Insert(at, stretch);
    }

    private void Keep(int start, int count)
    {
        count = Math.Min(count, _length - start);
        _bytes.AsSpan(start, count).CopyTo(_bytes);
        _length = count;
    }

    private void Overwrite(int at, ReadOnlySpan<byte> bytes)
    {
        if (at < _length)
            bytes[..Math.Min(bytes.Length, _length - at)].CopyTo(_bytes.AsSpan(at));
    }

    private void Remove(int at, int count)
    {
        count = Math.Min(count, _length - at);
        _bytes.AsSpan(at + count, _length - at - count).CopyTo(_bytes.AsSpan(at));
        _length -= count;
    }

    private void Insert(int at, ReadOnlySpan<byte> bytes)
    {
        bytes = bytes[..Math.Min(bytes.Length, FuzzInput.MaxLength - _length)];
        _bytes.AsSpan(at, _length - at).CopyTo(_bytes.AsSpan(at + bytes.Length));
        bytes.CopyTo(_bytes.AsSpan(at));
        _length += bytes.Length;
    }

    private ReadOnlySpan<byte> Copy(ReadOnlySpan<byte> bytes, int at, int count)
    {
        ReadOnlySpan<byte> stretch = bytes[at..Math.Min(at + count, bytes.Length)];
        stretch.CopyTo(_other);
        return _other.AsSpan(0, stretch.Length);
    }
}
