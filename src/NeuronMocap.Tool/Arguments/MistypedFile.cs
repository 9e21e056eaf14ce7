using System.Net;
using NeuronMocap.Tool.Files;

namespace NeuronMocap.Tool.Arguments;

/// <summary>Recognizes a mistyped file name, which would otherwise be the name of a computer.</summary>
internal static class MistypedFile
{
    // A folder with more files takes too long to search.
    private const int MostFiles = 10_000;

    /// <summary>Describes the mistake. Null if the word is not like the name of a file.</summary>
    /// <param name="word">A word that names no file.</param>
    public static string? Describe(string word)
    {
        string extension = Path.GetExtension(word).ToLowerInvariant();
        if (extension.Length < 2 || word.Contains(':', StringComparison.Ordinal) || IPAddress.TryParse(word, out _))
            return null;

        string remedy = $"For a computer of that name, write tcp://{word}.";
        if (Spelling.FindSlip(word, FilesHere()) is { } file)
            return $"there is no file '{word}': did you mean {file}? {remedy}";

        // The letters of an extension in another order. Names of computers end with domains, some of which differ from an extension in one letter.
        return FileKinds.Extensions.FirstOrDefault(known => extension.Order().SequenceEqual(known.Order())) is { } meant
            ? $"there is no file '{word}', and no kind of file ends with {extension}: did you mean {meant}? {remedy}"
            : null;
    }

    private static IEnumerable<string> FilesHere()
    {
        try
        {
            return [.. Directory.EnumerateFiles(".").Take(MostFiles).Select(static path => Path.GetFileName(path)).Where(static name => FileKinds.OfName(name) is not null)];
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            return [];
        }
    }
}
