using System.CommandLine;
using System.CommandLine.Parsing;

namespace NeuronMocap.Tool.Arguments;

/// <summary>The argument SOURCE of a verb.</summary>
internal sealed class SourceArgument : Argument<Source?>
{
    private readonly string _forms;

    /// <summary>Creates the argument.</summary>
    /// <param name="what">What the verb does with the source.</param>
    /// <param name="forms">The forms of a source that the verb accepts.</param>
    /// <param name="whenLeftOut">The default source; null if it must be given.</param>
    public SourceArgument(string what, string forms, string? whenLeftOut)
        : base("SOURCE")
    {
        _forms = forms;
        Description = $"{what}: {forms}. Write an IPv6 address with a port in brackets: [::1]:7001.{(whenLeftOut is null ? string.Empty : $" Default: {whenLeftOut}.")}";
        Arity = whenLeftOut is null ? ArgumentArity.ExactlyOne : ArgumentArity.ZeroOrOne;
        CustomParser = Parse;
        CompletionSources.Add("demo", "tcp://", "tls://", "ws://", "udp://:", "amqp://");
        if (forms.Contains(Source.VmcScheme, StringComparison.Ordinal))
            CompletionSources.Add(Source.VmcScheme + ":");
    }

    /// <summary>Gets the source on the command line. Null if it is missing or wrong.</summary>
    public Source? Find(CommandResult result) =>
        result.GetResult(this) is { Tokens: [var word, ..] } && Source.TryParse(word.Value, out Source? source, out _) ? source : null;

    private Source? Parse(ArgumentResult result)
    {
        if (result.Tokens.Count == 0)
            return null;
        if (!Source.TryParse(result.Tokens[0].Value, out Source? source, out string? error, _forms))
            result.AddError(error);

        return source;
    }
}
