using NeuronMocap.Fuzz.Grammar;

namespace NeuronMocap.Fuzz.Inputs;

/// <summary>Creates inputs from a corpus. Input number n of a seed is always the same.</summary>
internal sealed class Mutator
{
    private const int MostMutations = 12;

    // Offsets of the fields of packet headers. They are only useful relative to a token.
    private static readonly int[] FieldOffsets = [2, 4, 5, 6, 8, 9, 10, 14, 18, 22, 46, 50, 54, 62];

    private readonly Corpus _corpus;
    private readonly CorpusKind _kind;
    private readonly ulong _seed;
    private readonly InputBuffer _buffer = new();
    private readonly Grammars _grammars = new();
    private readonly GrammarMutator _parts;
    private FuzzRandom _random;

    public Mutator(Corpus corpus, CorpusKind kind, ulong seed)
    {
        _corpus = corpus;
        _kind = kind;
        _seed = seed;
        _parts = new GrammarMutator(_buffer);
    }

    private static ReadOnlySpan<byte> Spaces => " \r\n\t"u8;

    /// <summary>Creates an input.</summary>
    /// <param name="number">Its number, from 0. The first inputs are the unchanged fixtures.</param>
    /// <returns>The input, valid until the next call.</returns>
    public ReadOnlySpan<byte> Make(long number)
    {
        _random = new FuzzRandom(_seed ^ ((ulong)number * 0xD6E8FEB86659FD93));
        _buffer.Clear();
        if (number < _corpus.Fixtures.Count)
            _buffer.Append(_corpus.Fixtures[(int)number]);
        else if (_random.Below(2) == 0 && TryMakeOfParts())
            return _buffer.Bytes;
        else
            MakeOfBytes();

        return _buffer.Bytes;
    }

    // A whole fixture with changed parts, and sometimes a changed byte.
    private bool TryMakeOfParts()
    {
        _buffer.Clear();
        _buffer.Append(_random.Choose(_corpus.Fixtures));
        if (_grammars.Of(_kind, _buffer.Bytes) is not { } grammar)
        {
            _buffer.Clear();
            return false;
        }

        for (int changes = _random.Small(MostMutations); changes >= 0; changes--)
        {
            if (_random.Below(8) == 0)
                Change();
            else
                _parts.Change(grammar, ref _random);
        }

        return true;
    }

    private void MakeOfBytes()
    {
        for (int parts = _random.Below(3); parts >= 0; parts--)
            _buffer.Append(_random.Choose(_corpus.Fixtures));
        if (_random.Below(8) > 0)
            _buffer.Keep(_random.Below(3) > 0 ? 0 : _random.Below(_buffer.Length), 1 + _random.Below(1 << _random.Between(4, 13)));

        for (int changes = _random.Small(MostMutations); changes >= 0; changes--)
            Change();
    }

    private void Change()
    {
        int length = _buffer.Length;
        int at = _random.Below(length + 1);
        int count = 1 + _random.Small(Math.Max(1, length - at));
        switch (_random.Below(12))
        {
            case 0:
                _buffer.Overwrite(at, [(byte)_random.Next()]);
                break;
            case 1 when at < length:
                _buffer.Bytes[at] ^= (byte)(1 << _random.Below(8));
                break;
            case 2:
                _buffer.Overwrite(at, _random.Choose(_corpus.Words));
                break;
            case 3:
                _buffer.Insert(at, _random.Choose(_corpus.Words));
                break;
            case 4:
                OverwriteField(at);
                break;
            case 5:
                _buffer.Remove(at, count);
                break;
            case 6: // a stretch again, somewhere
                _buffer.Insert(_random.Below(length + 1), _buffer.Copy(_buffer.Bytes, at, count));
                break;
            case 7: // a stretch of another fixture
                byte[] other = _random.Choose(_corpus.Fixtures);
                _buffer.Insert(at, _buffer.Copy(other, _random.Below(other.Length), 1 + _random.Small(other.Length)));
                break;
            case 8: // one after the other, as often as fits
                Repeat(at, 1 + _random.Small(64), 1 + _random.Small(1_000));
                break;
            case 9: // the start of this one, the end of another
                byte[] end = _random.Choose(_corpus.Fixtures);
                _buffer.CutAt(at);
                _buffer.Insert(at, end.AsSpan(_random.Below(end.Length)));
                break;
            case 10:
                _buffer.CutAt(at);
                break;
            default:
                for (int i = 0; i < Math.Min(count, 16); i++)
                    _buffer.Overwrite(at + i, [(byte)_random.Next()]);
                break;
        }
    }

    // Writes a number to a field of the next header. If there is no header, as in text, it replaces the next word.
    private void OverwriteField(int at)
    {
        ReadOnlySpan<byte> rest = _buffer.Bytes[at..];
        int token = rest.IndexOf((byte)0xFF);
        if (token >= 0)
        {
            _buffer.Overwrite(at + token + _random.Choose(FieldOffsets), _random.Choose(_corpus.Words));
            return;
        }

        int start = Math.Max(0, rest.IndexOfAny(Spaces) + 1);
        int length = rest[start..].IndexOfAny(Spaces);
        _buffer.Replace(at + start, Math.Max(0, length), _random.Choose(_corpus.Words));
    }

    private void Repeat(int at, int size, int times)
    {
        ReadOnlySpan<byte> stretch = _buffer.Copy(_buffer.Bytes, at, size);
        int most = Math.Min(times, (FuzzInput.MaxLength - _buffer.Length) / Math.Max(1, stretch.Length));
        for (int i = 0; i < most && _buffer.Length < FuzzInput.MaxLength / 2; i++)
            _buffer.Insert(at, stretch);
    }
}
