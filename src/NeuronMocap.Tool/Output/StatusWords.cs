using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Output;

/// <summary>A status as this program says it.</summary>
internal static class StatusWords
{
    /// <summary>One or two sentences, fit for a terminal, that name options of this program.</summary>
    public static string Describe(this ConnectionStatus status) => TerminalText.Clean(OptionNames.Translate(status.Message ?? string.Empty));
}
