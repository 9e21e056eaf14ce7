namespace NeuronMocap.Monitor;

/// <summary>Text from the network, made fit for a terminal and for one line.</summary>
internal static class TerminalText
{
    // A name may hold an escape sequence, on purpose or not.
    public static string Clean(string text) =>
        text.Any(char.IsControl) ? string.Concat(text.Select(static letter => char.IsControl(letter) ? '·' : letter)) : text;
}
