using System.Text;

namespace NeuronMocap.Recording;

// Reads the data that ByteBuffer writes. Every Try method returns false if there are too few bytes.
internal ref struct ByteCursor(ReadOnlySpan<byte> bytes)
{
    private const int MaxNumberBytes = 9;

    private ReadOnlySpan<byte> _rest = bytes;

    public readonly ReadOnlySpan<byte> Rest => _rest;

    public bool TryTake(int count, out ReadOnlySpan<byte> bytes)
    {
        bool isThere = (uint)count <= (uint)_rest.Length;
        bytes = isThere ? _rest[..count] : default;
        _rest = _rest[bytes.Length..];
        return isThere;
    }

    // The range is 0 to long.MaxValue.
    public bool TryTakeNumber(out long value)
    {
        value = 0;
        for (int i = 0; i < MaxNumberBytes && i < _rest.Length; i++)
        {
            value |= (long)(_rest[i] & 0x7F) << (7 * i);
            if (_rest[i] >= 0x80)
                continue;

            _rest = _rest[(i + 1)..];
            return true;
        }

        return false;
    }

    public bool TryTakeNumber(out int value)
    {
        bool isThere = TryTakeNumber(out long number) && number <= int.MaxValue;
        value = isThere ? (int)number : 0;
        return isThere;
    }

    public bool TryTakeText(out string text)
    {
        text = string.Empty;
        if (!TryTakeNumber(out int length) || !TryTake(length, out ReadOnlySpan<byte> bytes))
            return false;

        text = Encoding.UTF8.GetString(bytes);
        return true;
    }

    public string TakeRestAsText()
    {
        string text = Encoding.UTF8.GetString(_rest);
        _rest = default;
        return text;
    }
}
