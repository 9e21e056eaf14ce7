namespace NeuronMocap.Tool.Arguments;

/// <summary>Shows an argument that may contain a password, as in amqps://USER:PASSWORD@HOST.</summary>
internal static class HiddenPassword
{
    private const string SchemeEnd = "://";

    /// <summary>Replaces what is before the last @ of a text, also if its scheme is missing or wrong.</summary>
    public static string In(string text)
    {
        int at = text.LastIndexOf('@');
        int scheme = text.IndexOf(SchemeEnd, StringComparison.Ordinal);
        return at < 0 ? text : scheme < 0 || at < scheme ? $"...{text[at..]}" : $"{text[..(scheme + SchemeEnd.Length)]}...{text[at..]}";
    }

    /// <summary>Whether a text without a scheme has a user and a password, as in USER:PASSWORD@HOST. No file is meant.</summary>
    public static bool IsIn(string text)
    {
        int colon = text.IndexOf(':');
        return colon >= 0 && text.LastIndexOf('@') > colon && !Path.IsPathFullyQualified(text) && !System.IO.File.Exists(text);
    }
}
