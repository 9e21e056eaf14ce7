using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Output;

/// <summary>Describes a status in the words of this program.</summary>
internal static class StatusWords
{
    /// <summary>Describes a status in one or two sentences that are safe for a terminal and name options of this program.</summary>
    public static string Describe(this ConnectionStatus status) => TerminalText.Clean(OptionNames.Translate(status.Message ?? string.Empty));
}
