using System.CommandLine;
using System.CommandLine.Parsing;
using System.Net;
using NeuronMocap.Protocol;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Commands;

/// <summary>neuron-mocap command: sends commands to a server's command channel.</summary>
internal sealed class CommandVerb : Verb
{
    private const string OrderWord = "order";

    private static readonly (string Word, CommandQuestion Question)[] Questions =
    [
        (OrderWord, CommandQuestion.Order), ("bones", CommandQuestion.Bones), ("header", CommandQuestion.Header), ("zero-out", CommandQuestion.ZeroOut),
    ];

    private readonly Argument<Source?> _server = new("HOST[:PORT]")
    {
        Description = "The server, with the port of its command channel, or demo for the simulator inside this program. "
            + $"Default port: {ProtocolConstants.DefaultCommandPort}.",
        Arity = ArgumentArity.ExactlyOne,
        CustomParser = static result => ParseServer(result),
    };

    private readonly Argument<CommandQuestion> _question = new("order|bones|header|zero-out")
    {
        Description = "order: the rotation order. bones: the sizes of an avatar's body, in metres. header: the avatar's BVH header, as the server sends it. "
            + "zero-out: zero out avatars. Default: the first three, in a report.",
        Arity = ArgumentArity.ZeroOrOne,
        CustomParser = static result => ParseQuestion(result),
    };

    private readonly Option<int?> _avatar = CommonOptions.Avatar(
        "Number of the avatar, from 0. Default: the first; for zero-out: all. Not for order.");

    private readonly Option<IPAddress?> _localAddress = CommonOptions.Address(
        "--local-address", "On a computer with several networks: connect from this address. Default: the address that the system chooses.");

    private readonly Option<bool> _json = CommonOptions.Json("Print the answer as one JSON object.");

    public CommandVerb()
        : base("command", "Ask a server's command channel. It knows what most streams lack: the rotation order and the avatars' bodies.")
    {
        _server.CompletionSources.Add(Source.Demo.ToString());
        _question.CompletionSources.Clear();
        _question.CompletionSources.Add([.. Questions.Select(static question => question.Word)]);
        Add(_server);
        Add(_question);
        AddOptions("Options", _avatar, _localAddress, _json);
        Validators.Add(Reject);
    }

    public override IReadOnlyList<HelpExample> Examples { get; } =
    [
        new("command 192.168.1.20", "rotation order, bone sizes and the contents of the BVH header; port 8013"),
        new("command 192.168.1.20 order", "the rotation order alone"),
        new("command 192.168.1.20:8014 header --avatar 1 > body.bvh", "the BVH header of the second avatar, from another port"),
        new("command 192.168.1.20 zero-out --avatar 0", "zeroes out avatar 0; without --avatar all of them"),
    ];

    public override IReadOnlyList<(int Code, string Meaning)> ExitCodes { get; } =
    [
        (ToolCommand.Done, "answered"),
        (ToolCommand.NothingReceived, "not answered; standard error says why"),
        (ToolCommand.Interrupted, "ended by Ctrl+C or SIGTERM before the answer"),
    ];

    public override Task<int> RunAsync(ParseResult result, StandardStreams streams, CancellationToken cancellationToken) => new CommandRun(
        new CommandSettings(result.GetValue(_server)!.Server, result.GetValue(_question), result.GetValue(_avatar), result.GetValue(_json))
        {
            LocalAddress = result.GetValue(_localAddress),
        },
        streams).RunAsync(cancellationToken);

    private void Reject(CommandResult result)
    {
        if (IsGiven(result, _avatar) && result.GetResult(_question) is { Tokens: [{ Value: var word }] } && word.Equals(OrderWord, StringComparison.OrdinalIgnoreCase))
            result.AddError("--avatar is not for order: all avatars of a server have the same rotation order.");
        if (IsGiven(result, _localAddress) && result.GetValue(_server) is { Kind: SourceKind.Demo })
            result.AddError("--local-address needs a server: the demo is inside this program.");
    }

    // Accepts the forms of TCP sources, with a different default port.
    private static Source? ParseServer(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (!Source.TryParse(text, out Source? source, out string? error, Source.ServerForms))
            result.AddError(error);
        else if (source.Kind == SourceKind.Tcp)
            return Source.OfServer(ServerAddress.ParseCommandChannel(text));
        else if (source.Kind != SourceKind.Demo)
            result.AddError($"'{HiddenPassword.In(text)}' has no command channel: give {Source.ServerForms}.");

        return source;
    }

    private static CommandQuestion ParseQuestion(ArgumentResult result)
    {
        if (result.Tokens.Count == 0)
            return CommandQuestion.All;

        string text = result.Tokens[0].Value;
        foreach ((string word, CommandQuestion question) in Questions)
        {
            if (word.Equals(text, StringComparison.OrdinalIgnoreCase))
                return question;
        }

        string? meant = Spelling.FindNearest(text, Questions.Select(static question => question.Word));
        result.AddError(meant is null
            ? $"'{text}' is not one of {string.Join(", ", Questions.Select(static question => question.Word))}."
            : $"unknown question '{text}': did you mean {meant}?");
        return CommandQuestion.All;
    }
}
