namespace NeuronMocap.Protocol;

// The bytes that are possible at each place in a line of text. They show as early as possible that bytes are not a line.
internal static class TextAlphabet
{
    private const int FirstWord = 1;

    // A name of 32 bytes cannot have more words.
    private const int MaxNameWords = 16;

    // Characters of the first word: an avatar's number, or a value. C libraries write some values as -nan(ind) or 1.#QNAN.
    private static ReadOnlySpan<byte> NumberLetters => "0123456789+-.,#()aAdDeEfFiInNqQsStTyY"u8;

    public static bool MayStartLine(byte letter) =>
        letter is >= (byte)'0' and <= (byte)'9' or (byte)'+' or (byte)'-' or (byte)'.' or (byte)',' or (byte)'n' or (byte)'N' or (byte)'i' or (byte)'I';

    // Words are counted from 1. Only the name, which can have several words, can contain bytes beyond ASCII. Even there, 0xFF and the sequence 0xCF 0xDC
    // are not UTF-8; tokens begin with them.
    public static bool MayStandInWord(int word, byte letter, byte previous)
    {
        if (letter >= 0x80)
            return word is > FirstWord and <= FirstWord + MaxNameWords && letter != ProtocolConstants.TokenStart && !(letter == ProtocolConstants.StudioToken1 && previous == ProtocolConstants.StudioTokenStart);

        return letter is > (byte)' ' and < 0x7F && (word != FirstWord || NumberLetters.IndexOf(letter) >= 0);
    }
}
