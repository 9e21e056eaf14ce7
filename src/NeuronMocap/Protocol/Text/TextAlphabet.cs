namespace NeuronMocap.Protocol;

// Which bytes can stand where in a line of text, so that bytes that are none are known as early as possible.
internal static class TextAlphabet
{
    private const int FirstWord = 1;

    // A name of 32 bytes has no more.
    private const int MaxNameWords = 16;

    // Of the first word: an avatar's number, or a value, which C libraries also write as -nan(ind) or 1.#QNAN.
    private static ReadOnlySpan<byte> NumberLetters => "0123456789+-.,#()aAdDeEfFiInNqQsStTyY"u8;

    public static bool MayStartLine(byte letter) =>
        letter is >= (byte)'0' and <= (byte)'9' or (byte)'+' or (byte)'-' or (byte)'.' or (byte)',' or (byte)'n' or (byte)'N' or (byte)'i' or (byte)'I';

    // Words are counted from 1. Letters beyond ASCII are the name's alone, which may have several words, and even there 0xFF, and 0xDC behind 0xCF, are not UTF-8: these are
    // what tokens begin with.
    public static bool MayStandInWord(int word, byte letter, byte previous)
    {
        if (letter >= 0x80)
            return word is > FirstWord and <= FirstWord + MaxNameWords && letter != ProtocolConstants.TokenStart && !(letter == ProtocolConstants.StudioToken1 && previous == ProtocolConstants.StudioTokenStart);

        return letter is > (byte)' ' and < 0x7F && (word != FirstWord || NumberLetters.IndexOf(letter) >= 0);
    }
}
