namespace NeuronMocap.Tool.Arguments;

/// <summary>Finds the word that a misspelt word probably means.</summary>
internal static class Spelling
{
    // At most one wrong letter in three. Words with more differences are too unlike.
    private const int LettersPerSlip = 3;

    /// <summary>Finds the nearest word. Null if no word is near.</summary>
    public static string? FindNearest(string typed, IEnumerable<string> words)
    {
        (string Word, int Slips) best = words
            .Select(word => (word, Slips: CountSlips(typed.ToLowerInvariant(), word)))
            .OrderBy(static candidate => candidate.Slips)
            .ThenBy(static candidate => candidate.word, StringComparer.Ordinal)
            .FirstOrDefault((string.Empty, int.MaxValue));
        return best.Slips <= Math.Max(1, typed.Length / LettersPerSlip) ? best.Word : null;
    }

    /// <summary>Finds a word that differs by one slip. Null if there is none.</summary>
    public static string? FindSlip(string typed, IEnumerable<string> words) =>
        words.Order(StringComparer.Ordinal).FirstOrDefault(word => CountSlips(typed.ToLowerInvariant(), word.ToLowerInvariant()) == 1);

    // Counts the letters to change, add, remove or swap with the next. The start of a word counts as the word.
    private static int CountSlips(string typed, string word)
    {
        if (typed.Length > 1 && word.StartsWith(typed, StringComparison.Ordinal))
            return 1;

        int[,] slips = new int[typed.Length + 1, word.Length + 1];
        for (int i = 0; i <= typed.Length; i++)
        {
            for (int j = 0; j <= word.Length; j++)
            {
                slips[i, j] = i == 0 || j == 0
                    ? i + j
                    : Math.Min(slips[i - 1, j - 1] + (typed[i - 1] == word[j - 1] ? 0 : 1), Math.Min(slips[i - 1, j], slips[i, j - 1]) + 1);
                if (i > 1 && j > 1 && typed[i - 1] == word[j - 2] && typed[i - 2] == word[j - 1])
                    slips[i, j] = Math.Min(slips[i, j], slips[i - 2, j - 2] + 1);
            }
        }

        return slips[typed.Length, word.Length];
    }
}
