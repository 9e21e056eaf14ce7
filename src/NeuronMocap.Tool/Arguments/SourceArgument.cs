using System.CommandLine;
using System.CommandLine.Parsing;

namespace NeuronMocap.Tool.Arguments;

/// <summary>The word SOURCE of a verb.</summary>
internal sealed class SourceArgument : Argument<Source?>
{
    /// <summary>Makes the argument.</summary>
    /// <param name="what">What the verb does with it.</param>
    /// <param name="whenLeftOut">What stands for none.</param>
    public SourceArgument(string what, string whenLeftOut)
        : base("SOURCE")
    {
        Description = $"{what}: {Source.Forms}. An IPv6 address with a port stands in brackets: [::1]:7001. Default: {whenLeftOut}.";
        Arity = ArgumentArity.ZeroOrOne;
        CustomParser = Parse;
        CompletionSources.Add("demo", "tcp://", "udp://:");
    }

    /// <summary>What the command line names; null without a source, and where it is wrong.</summary>
    public Source? Find(CommandResult result) =>
        result.GetResult(this) is { Tokens: [var word, ..] } && Source.TryParse(word.Value, out Source? source, out _) ? source : null;

    private static Source? Parse(ArgumentResult result)
    {
        if (result.Tokens.Count == 0)
            return null;
        if (!Source.TryParse(result.Tokens[0].Value, out Source? source, out string? error))
            result.AddError(error);

        return source;
    }
}
