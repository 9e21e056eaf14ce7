using System.Globalization;
using NeuronMocap.Server;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Relay.Destinations;

/// <summary>A program that takes poses over OSC.</summary>
/// <param name="Text">The argument of the command line.</param>
/// <param name="Address">The computer and its port.</param>
/// <param name="Avatar">The only avatar; null if none is named.</param>
internal abstract record PoseDestination(string Text, ServerAddress Address, NamedAvatar? Avatar) : Destination(Text)
{
    /// <summary>Settings that all destinations for poses share.</summary>
    public PoseSettings Settings { get; init; } = new();

    public sealed override bool IsSame(Destination other) => other is PoseDestination pose && pose.Address == Address;

    public sealed override Outlet Open(NeuronReader reader, bool overwrite)
    {
        // A name that is mistyped is said at once. Later the sender looks it up again and again.
        DestinationHost.Resolve(Text, Address);
        PoseSender sender = CreateSender(reader);
        sender.Start();
        return new PoseOutlet(sender, reader, Text, Avatar);
    }

    protected abstract PoseSender CreateSender(NeuronReader reader);

    /// <summary>Parses HOST:PORT or HOST:PORT/AVATAR after the scheme.</summary>
    /// <param name="text">The destination.</param>
    /// <param name="scheme">Its scheme.</param>
    /// <param name="defaultPort">The port if none is given; null if it must be given.</param>
    protected static (ServerAddress Address, NamedAvatar? Avatar) Parse(string text, string scheme, int? defaultPort = null)
    {
        string rest = text[scheme.Length..];
        int slash = rest.IndexOf('/', StringComparison.Ordinal);
        try
        {
            ServerAddress address = ParseAddress(slash < 0 ? rest : rest[..slash], defaultPort);
            return (address, slash < 0 || slash == rest.Length - 1 ? null : new NamedAvatar(rest[(slash + 1)..]));
        }
        catch (FormatException fault)
        {
            string port = defaultPort is { } usual ? string.Create(CultureInfo.InvariantCulture, $" The port is {usual} if it is left out.") : string.Empty;
            string place = defaultPort is null ? "computer and port" : "computer";
            throw new FormatException($"'{text}' names no {place} to send to. Use {scheme}HOST:PORT, or {scheme}HOST:PORT/AVATAR.{port}", fault);
        }
    }

    // A text without a port gets one. A number alone is meant as a port, although it could be read as an address.
    private static ServerAddress ParseAddress(string text, int? defaultPort)
    {
        try
        {
            return ServerAddress.ParseDestination(text);
        }
        catch (FormatException) when (defaultPort is not null && !text.All(char.IsAsciiDigit))
        {
            return ServerAddress.ParseDestination(string.Create(CultureInfo.InvariantCulture, $"{text}:{defaultPort}"));
        }
    }
}

/// <summary>vmc://HOST[:PORT][/AVATAR]: sends one avatar to a program that takes the Virtual Motion Capture protocol.</summary>
/// <inheritdoc cref="PoseDestination"/>
internal sealed record VmcDestination(string Text, ServerAddress Address, NamedAvatar? Avatar) : PoseDestination(Text, Address, Avatar)
{
    public const string Scheme = "vmc://";

    public static VmcDestination Parse(string text)
    {
        (ServerAddress address, NamedAvatar? avatar) = Parse(text, Scheme, Source.DefaultVmcPort);
        return new VmcDestination($"{Scheme}{address}{(avatar is null ? string.Empty : "/" + avatar.Text)}", address, avatar);
    }

    protected override PoseSender CreateSender(NeuronReader reader) => new VmcSender(reader, new VmcSenderOptions
    {
        Host = Address.Host,
        Port = Address.Port,
        AvatarIndex = Avatar?.Index,
        AvatarName = Avatar?.Name,
        MaxRate = Settings.Rate,
        Scale = Settings.Scale,
        MoveRoot = Settings.MoveRoot,
    });
}

/// <summary>osc://HOST:PORT[/AVATAR]: sends all avatars, or one, as plain OSC messages.</summary>
/// <inheritdoc cref="PoseDestination"/>
internal sealed record OscDestination(string Text, ServerAddress Address, NamedAvatar? Avatar) : PoseDestination(Text, Address, Avatar)
{
    public const string Scheme = "osc://";

    public static OscDestination Parse(string text)
    {
        (ServerAddress address, NamedAvatar? avatar) = Parse(text, Scheme);
        return new OscDestination(text, address, avatar);
    }

    protected override PoseSender CreateSender(NeuronReader reader) => new OscSender(reader, new OscSenderOptions
    {
        Host = Address.Host,
        Port = Address.Port,
        AvatarIndex = Avatar?.Index,
        AvatarName = Avatar?.Name,
        MaxRate = Settings.Rate,
        Scale = Settings.Scale,
        Space = Settings.Space,
    });
}
