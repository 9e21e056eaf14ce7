namespace NeuronMocap.Tool.Arguments;

/// <summary>Shows an argument that may contain a password, as in amqps://USER:PASSWORD@HOST.</summary>
internal static class HiddenPassword
{
    private const string SchemeEnd = "://";

    /// <summary>Replaces what is before the last @ of an address.</summary>
    public static string In(string text)
    {
        int scheme = text.IndexOf(SchemeEnd, StringComparison.Ordinal);
        int at = text.LastIndexOf('@');
        return scheme < 0 || at < scheme ? text : $"{text[..(scheme + SchemeEnd.Length)]}...{text[at..]}";
    }
}
