namespace NeuronMocap.Transport;

// Recognizes the text format (protocol.md section 8): "0 Char00 0.00 93.02", with avatar number, name and values. Calculation data has only values.
internal static class NumericText
{
    // A word in this place is the avatar's name. The text after the last separator may be cut off anywhere and is ignored.
    private const int NameIndex = 1;

    // Largest number of words in a name, and of numbers after it that are not a version or an address.
    private const int MaxNames = 4;
    private const int MinNumbers = 4;

    public static bool IsAt(ReadOnlySpan<byte> bytes)
    {
        int words = 0;
        int numbers = 0;
        int start = 0;
        for (int i = 0; i < bytes.Length; i++)
        {
            if (!IsSeparator(bytes[i]))
            {
                if (bytes[i] < 0x20)
                    return false;

                continue;
            }

            ReadOnlySpan<byte> word = bytes[start..i];
            start = i + 1;
            if (word.Length > 0)
            {
                if (IsNumber(word))
                    numbers++;
                else if (words != NameIndex)
                    return false;

                words++;
            }

            if (bytes[i] is (byte)'|' or (byte)'\n')
                words = 0;
        }

        return numbers > 1;
    }

    // Whether the bytes begin with a few words that are not numbers, and then contain only numbers: a line of the format without the avatar's number.
    public static bool BeginsWithName(ReadOnlySpan<byte> bytes)
    {
        int names = 0;
        int numbers = 0;
        int start = 0;
        for (int i = 0; i < bytes.Length && bytes[i] is not ((byte)'|' or (byte)'\n'); i++)
        {
            if (!IsSeparator(bytes[i]))
            {
                if (bytes[i] < 0x20)
                    return false;

                continue;
            }

            ReadOnlySpan<byte> word = bytes[start..i];
            start = i + 1;
            if (word.Length == 0)
                continue;

            if (IsNumber(word))
                numbers++;
            else if (numbers > 0 || ++names > MaxNames)
                return false;
        }

        return names > 0 && numbers >= MinNumbers;
    }

    // A public emulator sends extra zero bytes between the lines, and "||" ends each avatar's values.
    private static bool IsSeparator(byte value) => value is 0 or (byte)' ' or (byte)'\t' or (byte)'\r' or (byte)'\n' or (byte)'|';

    private static bool IsNumber(ReadOnlySpan<byte> word)
    {
        bool digit = false;
        foreach (byte value in word)
        {
            if (value is >= (byte)'0' and <= (byte)'9')
                digit = true;
            else if (value is not ((byte)'.' or (byte)'-' or (byte)'+' or (byte)'e' or (byte)'E'))
                return false;
        }

        return digit;
    }
}
