using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using NeuronMocap.Protocol;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Commands;

/// <summary>The options of the command channel.</summary>
internal sealed class CommandArguments
{
    private readonly Option<ServerAddress?> _commands = new("--commands")
    {
        HelpName = "HOST[:PORT]",
        Description = "Ask this server's command channel, which has a port of its own, instead of showing its stream: print the rotation order, the "
            + $"sizes of an avatar's body and what its BVH header says. Default port {ProtocolConstants.DefaultCommandPort}. Without HOST[:PORT]: this "
            + "computer, or the simulator of --demo.",
        CustomParser = ParseServer,
        Arity = ArgumentArity.ZeroOrOne,
    };

    private readonly Option<int?> _avatar = new("--avatar")
    {
        HelpName = "N",
        Description = "With --commands: the avatar to ask about, from 0. Default 0. With a recording: the avatar to take, by its index. Default: the first.",
        CustomParser = static result => ParseAvatar(result, "a number of an avatar, from 0"),
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<ZeroOutTarget?> _zeroOut = new("--zero-out")
    {
        HelpName = "N|all",
        Description = "With --commands: ask the server to zero out this avatar, or all of them, and print nothing else.",
        CustomParser = static result => string.Equals(result.Tokens[0].Value, "all", StringComparison.OrdinalIgnoreCase)
            ? new ZeroOutTarget(Avatar: null)
            : ParseAvatar(result, "a number of an avatar, from 0, or all") is { } avatar ? new ZeroOutTarget(avatar) : null,
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<bool> _header = new("--bvh-header")
    {
        Description = "With --commands: print the avatar's BVH header as the server sends it, and nothing else.",
        Arity = ArgumentArity.Zero,
    };

    /// <summary>Which avatar; the tools for files ask it, too.</summary>
    public Option<int?> Avatar => _avatar;

    /// <summary>The options that only a command channel understands.</summary>
    public Option[] Own => [_commands, _zeroOut, _header];

    /// <summary>The option that asks for the command channel instead of a stream.</summary>
    public Option Main => _commands;

    public void AddTo(RootCommand root)
    {
        foreach (Option option in (Option[])[_commands, _avatar, _zeroOut, _header])
            root.Options.Add(option);
    }

    /// <summary>Adds an error for every option that has no meaning beside another.</summary>
    /// <param name="result">The command line.</param>
    /// <param name="ofStream">Options that are about a stream.</param>
    /// <param name="json">The option that asks for JSON.</param>
    public void RejectContradictions(CommandResult result, Option[] ofStream, Option json)
    {
        if (!CommandLine.IsGiven(result, _commands))
        {
            foreach (Option option in ((Option[])[_avatar, _zeroOut, _header]).Where(option => CommandLine.IsGiven(result, option)))
                result.AddError($"{option.Name} needs --commands: only a command channel answers it.");

            return;
        }

        foreach (Option option in ofStream.Where(option => CommandLine.IsGiven(result, option)))
            result.AddError($"--commands and {option.Name} exclude each other.");

        Option[] kinds = [.. ((Option[])[_zeroOut, _header, json]).Where(option => CommandLine.IsGiven(result, option))];
        if (kinds.Contains(_header) && kinds.Length > 1)
            result.AddError($"--bvh-header and {kinds.First(option => option != _header).Name} exclude each other.");
        if (CommandLine.IsGiven(result, _zeroOut) && CommandLine.IsGiven(result, _avatar))
            result.AddError("--zero-out and --avatar exclude each other: --zero-out names the avatar.");
    }

    public CommandSettings? Read(ParseResult result, bool isDemo)
    {
        if (result.GetResult(_commands) is not { Implicit: false })
            return null;

        ServerAddress? server = result.GetValue(_commands)
            ?? (isDemo ? null : new ServerAddress("127.0.0.1", ProtocolConstants.DefaultCommandPort));
        return new CommandSettings(server, result.GetValue(_avatar) ?? 0, result.GetValue(_zeroOut), result.GetValue(_header));
    }

    private static ServerAddress? ParseServer(ArgumentResult result)
    {
        if (result.Tokens.Count == 0)
            return null;
        if (ServerAddress.TryParse(result.Tokens[0].Value, out ServerAddress address, out string? error, ProtocolConstants.DefaultCommandPort))
            return address;

        result.AddError($"--commands: {error}");
        return null;
    }

    private static int? ParseAvatar(ArgumentResult result, string expected)
    {
        string text = result.Tokens[0].Value;
        if (int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int avatar))
            return avatar;

        result.AddError($"{((OptionResult)result.Parent!).Option.Name}: '{text}' is not {expected}.");
        return null;
    }
}
