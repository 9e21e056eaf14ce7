namespace NeuronMocap.Tool.Arguments;

/// <summary>Finds the word that was meant by one with a slip in it.</summary>
internal static class Spelling
{
    // Of two letters in three that are the same nobody means another word.
    private const int LettersPerSlip = 3;

    /// <summary>The nearest word; null when none is near.</summary>
    public static string? FindNearest(string typed, IEnumerable<string> words)
    {
        (string Word, int Slips) best = words
            .Select(word => (word, Slips: CountSlips(typed.ToLowerInvariant(), word)))
            .OrderBy(static candidate => candidate.Slips)
            .ThenBy(static candidate => candidate.word, StringComparer.Ordinal)
            .FirstOrDefault((string.Empty, int.MaxValue));
        return best.Slips <= Math.Max(1, typed.Length / LettersPerSlip) ? best.Word : null;
    }

    // Letters to change, add or leave out; the beginning of a word is as good as the word.
    private static int CountSlips(string typed, string word)
    {
        if (typed.Length > 1 && word.StartsWith(typed, StringComparison.Ordinal))
            return 1;

        int[] row = [.. Enumerable.Range(0, word.Length + 1)];
        for (int i = 0; i < typed.Length; i++)
        {
            int diagonal = row[0];
            row[0] = i + 1;
            for (int j = 0; j < word.Length; j++)
            {
                int changed = diagonal + (typed[i] == word[j] ? 0 : 1);
                diagonal = row[j + 1];
                row[j + 1] = Math.Min(changed, Math.Min(diagonal, row[j]) + 1);
            }
        }

        return row[^1];
    }
}
