using System.Globalization;
using NeuronMocap.Server;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Relay.Destinations;

/// <summary>A program that takes poses over OSC.</summary>
/// <param name="Text">The argument of the command line.</param>
/// <param name="Address">The computer and its port.</param>
/// <param name="Avatar">The number or the name of the only avatar; null if none is named.</param>
internal abstract record PoseDestination(string Text, ServerAddress Address, string? Avatar) : Destination(Text)
{
    /// <summary>Settings that all destinations for poses share.</summary>
    public PoseSettings Settings { get; init; } = new();

    /// <summary>The avatar, if it is named by its number.</summary>
    protected int? AvatarIndex => int.TryParse(Avatar, NumberStyles.None, CultureInfo.InvariantCulture, out int index) ? index : null;

    /// <summary>The avatar, if it is named by its name.</summary>
    protected string? AvatarName => AvatarIndex is null ? Avatar : null;

    public sealed override bool IsSame(Destination other) => other is PoseDestination pose && pose.Address == Address;

    public sealed override Outlet Open(NeuronReader reader, bool overwrite)
    {
        // A name that is mistyped is said at once. Later the sender looks it up again and again.
        DestinationHost.Resolve(Text, Address);
        PoseSender sender = CreateSender(reader);
        sender.Start();
        return new PoseOutlet(sender, Text);
    }

    protected abstract PoseSender CreateSender(NeuronReader reader);

    /// <summary>Parses HOST:PORT or HOST:PORT/AVATAR after the scheme.</summary>
    protected static (ServerAddress Address, string? Avatar) Parse(string text, string scheme)
    {
        string rest = text[scheme.Length..];
        int slash = rest.IndexOf('/', StringComparison.Ordinal);
        try
        {
            var address = ServerAddress.ParseDestination(slash < 0 ? rest : rest[..slash]);
            return (address, slash < 0 || slash == rest.Length - 1 ? null : rest[(slash + 1)..]);
        }
        catch (FormatException fault)
        {
            throw new FormatException($"'{text}' names no computer and port to send to. Use {scheme}HOST:PORT, or {scheme}HOST:PORT/AVATAR.", fault);
        }
    }
}

/// <summary>vmc://HOST:PORT[/AVATAR]: sends one avatar to a program that takes the Virtual Motion Capture protocol.</summary>
/// <inheritdoc cref="PoseDestination"/>
internal sealed record VmcDestination(string Text, ServerAddress Address, string? Avatar) : PoseDestination(Text, Address, Avatar)
{
    public const string Scheme = "vmc://";

    public static VmcDestination Parse(string text)
    {
        (ServerAddress address, string? avatar) = Parse(text, Scheme);
        return new VmcDestination(text, address, avatar);
    }

    protected override PoseSender CreateSender(NeuronReader reader) => new VmcSender(reader, new VmcSenderOptions
    {
        Host = Address.Host,
        Port = Address.Port,
        AvatarIndex = AvatarIndex,
        AvatarName = AvatarName,
        MaxRate = Settings.Rate,
        Scale = Settings.Scale,
        MoveRoot = Settings.MoveRoot,
    });
}

/// <summary>osc://HOST:PORT[/AVATAR]: sends all avatars, or one, as plain OSC messages.</summary>
/// <inheritdoc cref="PoseDestination"/>
internal sealed record OscDestination(string Text, ServerAddress Address, string? Avatar) : PoseDestination(Text, Address, Avatar)
{
    public const string Scheme = "osc://";

    public static OscDestination Parse(string text)
    {
        (ServerAddress address, string? avatar) = Parse(text, Scheme);
        return new OscDestination(text, address, avatar);
    }

    protected override PoseSender CreateSender(NeuronReader reader) => new OscSender(reader, new OscSenderOptions
    {
        Host = Address.Host,
        Port = Address.Port,
        AvatarIndex = AvatarIndex,
        AvatarName = AvatarName,
        MaxRate = Settings.Rate,
        Scale = Settings.Scale,
        Space = Settings.Space,
    });
}
