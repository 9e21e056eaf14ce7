using System.Buffers.Binary;

namespace NeuronMocap.Protocol;

// Makes the binary image of a packet from a line of the text stream (protocol.md section 8): avatar number, name, values. Calculation lines can have only
// values. The number of words determines the kind of line, so a name can be a number. In a name of several words, no word can be a number. The image has
// the version None and lacks the second token, so no bytes of a stream can be mistaken for one. The next line reuses its memory. Not thread-safe.
internal sealed class TextLine(int maxValues)
{
    // The avatar's number and name, before the values.
    private const int Leading = 2;

    // Numbers have fewer characters; a longer word is not a number.
    private const int LongestNumber = 128;

    private const int MinWords = 3;

    // If a line has up to this many extra words, they probably belong to the name, not to the values.
    private const int MaxNameExcess = 5;

    private byte[] _image = [];
    private byte[] _withoutZeros = [];

    public byte[] Image => _image;

    public int ImageLength { get; private set; }

    public static bool IsImage(ReadOnlySpan<byte> packet) => packet[ProtocolConstants.HeaderSize - 1] == 0;

    // Whether a byte separates two words. A zero byte does not separate words: it is ignored everywhere.
    public static bool IsSeparator(byte value) => value is (byte)' ' or (byte)'\t' or (byte)'\r' or (byte)'\n' or (byte)'|';

    // Whether the bytes begin as only a complete line can: a number, a name without numbers, and a number. If it is not known whether the beginning is
    // missing, this shows that it is not.
    public static bool BeginsLine(ReadOnlySpan<byte> line) =>
        line.Length > 0 && !IsSeparator(line[0]) && IsIndex(TakeWord(ref line), out _) && TakeName(ref line) > 0 && IsNumber(TakeWord(ref line));

    // Returns None if the line is not a frame; the reason then says why. NoTokens means that it is not a line of this format, or may be the rest of a line
    // whose beginning was missed.
    public PacketKind Read(ReadOnlySpan<byte> line, int words, bool isWhole, out SkipReason reason)
    {
        line = WithoutZeros(line);
        reason = SkipReason.NoTokens;
        bool isLineStart = BeginsLine(line);
        if (!isWhole && !isLineStart)
            return PacketKind.None;

        PacketKind kind = Read(line, words, nameWords: 1, ref reason);
        int nameWords = isLineStart ? CountNameWords(line) : 0;
        if (kind == PacketKind.None && nameWords > 1)
            kind = Read(line, words, nameWords, ref reason);
        if (kind == PacketKind.None && reason == SkipReason.NoTokens && (isLineStart || IsLike(line, words)))
            reason = Explain(words, isLineStart);

        return kind;
    }

    private PacketKind Read(ReadOnlySpan<byte> line, int words, int nameWords, ref SkipReason reason)
    {
        (PacketKind kind, int count) = KindOf(words - nameWords + 1);
        if (count > maxValues)
        {
            reason = SkipReason.TooLarge;
            return PacketKind.None;
        }

        return kind != PacketKind.None && TryRead(line, kind, count, words == count ? 0 : nameWords) ? kind : PacketKind.None;
    }

    private static SkipReason Explain(int words, bool isLineStart)
    {
        if (isLineStart)
            return HasNameExcess(words) ? SkipReason.AmbiguousName : SkipReason.MalformedLine;

        return KindOf(words + Leading).Kind == PacketKind.Motion ? SkipReason.MissingAvatar : SkipReason.MalformedLine;
    }

    private static bool HasNameExcess(int words)
    {
        for (int excess = 1; excess <= MaxNameExcess; excess++)
        {
            if (KindOf(words - excess) is (not PacketKind.None, var count) && count < words - excess)
                return true;
        }

        return false;
    }

    private static int CountNameWords(ReadOnlySpan<byte> line)
    {
        TakeWord(ref line);
        return TakeName(ref line);
    }

    private static (PacketKind Kind, int Count) KindOf(int words) => words switch
    {
        180 + Leading or 186 + Leading or 354 + Leading or 360 + Leading => (PacketKind.Motion, words - Leading),
        338 + Leading or 946 + Leading => (PacketKind.Calculation, words - Leading),
        338 or 946 => (PacketKind.Calculation, words),
        _ => (PacketKind.None, 0),
    };

    private static bool IsLike(ReadOnlySpan<byte> line, int words)
    {
        if (words < MinWords || !IsNumber(TakeWord(ref line)))
            return false;

        TakeWord(ref line);
        return IsNumber(TakeWord(ref line));
    }

    // A line without a name has no avatar number either.
    private bool TryRead(ReadOnlySpan<byte> line, PacketKind kind, int count, int nameWords)
    {
        uint avatar = 0;
        ReadOnlySpan<byte> name = default;
        if (nameWords > 0)
        {
            if (!IsIndex(TakeWord(ref line), out avatar))
                return false;

            name = TakeWords(ref line, nameWords);
        }

        ImageLength = ProtocolConstants.HeaderSize + (count * sizeof(float));
        if (_image.Length < ImageLength)
            _image = new byte[ImageLength];

        for (int at = ProtocolConstants.HeaderSize; at < ImageLength; at += sizeof(float))
        {
            if (!TryParse(TakeWord(ref line), out float value))
                return false;

            BinaryPrimitives.WriteInt32LittleEndian(_image.AsSpan(at), BitConverter.SingleToInt32Bits(value));
        }

        WriteHeader(kind, count, avatar, NameOf(name));
        return true;
    }

    private void WriteHeader(PacketKind kind, int count, uint avatar, in AvatarName name)
    {
        if (kind == PacketKind.Motion)
        {
            new MotionHeader
            {
                Version = DataVersion.None,
                ValueCount = count,
                HasDisplacement = count >= 354,
                HasReference = count is 186 or 360,
                AvatarIndex = (int)avatar,
                AvatarName = name,
            }.Write(_image);
        }
        else
        {
            new CalculationHeader { Version = DataVersion.None, ValueCount = count, AvatarIndex = (int)avatar, AvatarName = name }.Write(_image);
        }

        _image.AsSpan(ProtocolConstants.Token2Offset, 2).Clear();
    }

    // Bytes that do not fit are cut off, between two characters.
    private static AvatarName NameOf(ReadOnlySpan<byte> name)
    {
        if (name.Length <= ProtocolConstants.AvatarNameSize)
            return new AvatarName(name);

        int length = ProtocolConstants.AvatarNameSize;
        while (length > 0 && (name[length] & 0xC0) == 0x80)
            length--;

        return new AvatarName(name[..length]);
    }

    // The result is valid until the next line.
    private ReadOnlySpan<byte> WithoutZeros(ReadOnlySpan<byte> line)
    {
        if (line.IndexOf((byte)0) < 0)
            return line;

        if (_withoutZeros.Length < line.Length)
            _withoutZeros = new byte[Math.Max(line.Length, 2 * _withoutZeros.Length)];

        int length = 0;
        foreach (byte value in line)
        {
            if (value != 0)
                _withoutZeros[length++] = value;
        }

        return _withoutZeros.AsSpan(0, length);
    }

    // Takes the words up to the next number or the end, and returns their number.
    private static int TakeName(scoped ref ReadOnlySpan<byte> line)
    {
        for (int count = 0; ; count++)
        {
            ReadOnlySpan<byte> rest = line;
            ReadOnlySpan<byte> word = TakeWord(ref rest);
            if (word.IsEmpty || IsNumber(word))
                return count;

            line = rest;
        }
    }

    // Takes several words, including the separators between them.
    private static ReadOnlySpan<byte> TakeWords(scoped ref ReadOnlySpan<byte> line, int count)
    {
        ReadOnlySpan<byte> all = line;
        int length = TakeWord(ref line).Length;
        int start = all.Length - line.Length - length;
        for (int i = 1; i < count; i++)
            TakeWord(ref line);

        return all[start..^line.Length];
    }

    private static ReadOnlySpan<byte> TakeWord(scoped ref ReadOnlySpan<byte> line)
    {
        int start = 0;
        while (start < line.Length && IsSeparator(line[start]))
            start++;

        int end = start;
        while (end < line.Length && !IsSeparator(line[end]))
            end++;

        ReadOnlySpan<byte> word = line[start..end];
        line = line[end..];
        return word;
    }

    private static bool IsIndex(ReadOnlySpan<byte> word, out uint index)
    {
        ulong number = 0;
        foreach (byte letter in word)
        {
            if (letter is < (byte)'0' or > (byte)'9')
            {
                number = ulong.MaxValue;
                break;
            }

            number = Math.Min((number * 10) + (ulong)(letter - '0'), uint.MaxValue + 1UL);
        }

        index = (uint)number;
        return word.Length > 0 && number <= uint.MaxValue;
    }

    private static bool IsNumber(ReadOnlySpan<byte> word) => TryParse(word, out _);

    // Servers in some languages write a comma as the decimal point.
    private static bool TryParse(ReadOnlySpan<byte> word, out float value)
    {
        int comma = word.IndexOf((byte)',');
        if (comma < 0 && word.Length <= LongestNumber)
            return TextNumber.TryParse(word, out value);

        value = 0;
        if (word.Length > LongestNumber)
            return false;

        Span<byte> pointed = stackalloc byte[LongestNumber];
        word.CopyTo(pointed);
        pointed[comma] = (byte)'.';
        return TextNumber.TryParse(pointed[..word.Length], out value);
    }
}
