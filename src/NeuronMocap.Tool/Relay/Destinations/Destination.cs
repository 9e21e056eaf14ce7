using System.Diagnostics.CodeAnalysis;
using System.Net;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Files;

namespace NeuronMocap.Tool.Relay.Destinations;

/// <summary>The meaning of TO: where packets go.</summary>
/// <param name="Text">The argument of the command line, without a password.</param>
internal abstract record Destination(string Text)
{
    // To add a scheme, write a record that opens it, and add a row.
    private static readonly (string Form, Func<string, bool> IsMeant, Func<string, Destination> Parse)[] Schemes =
    [
        ("tcp://[ADDRESS]:PORT", StartsWith(TcpDestination.Scheme), TcpDestination.Parse),
        ("ws://[ADDRESS]:PORT", StartsWith(WebSocketDestination.Scheme), WebSocketDestination.Parse),
        ("udp://HOST:PORT", StartsWith(UdpDestination.Scheme), UdpDestination.Parse),
        ("vmc://HOST[:PORT][/AVATAR]", StartsWith(VmcDestination.Scheme), VmcDestination.Parse),
        ("osc://HOST:PORT[/AVATAR]", StartsWith(OscDestination.Scheme), OscDestination.Parse),
        (RabbitMqDestination.Form, StartsWith(RabbitMqDestination.Scheme), RabbitMqDestination.Parse),
        ("FILE.nmrec", static text => FileKinds.OfName(text) == FileKind.Recording, static text => new RecordingDestination(text)),
        ("FILE.bvh", static text => FileKinds.OfName(text) == FileKind.Bvh, static text => new BvhDestination(text)),
    ];

    /// <summary>The forms of a destination, for help and errors.</summary>
    public static string Forms { get; } = $"{string.Join(", ", Schemes.SkipLast(1).Select(static scheme => scheme.Form))} or {Schemes[^1].Form}";

    /// <summary>The file to write; null for other destinations.</summary>
    public virtual string? File => null;

    /// <summary>Where this program listens for clients; null for other destinations.</summary>
    public virtual IPEndPoint? Listening => null;

    /// <summary>Parses a destination.</summary>
    /// <param name="text">An argument of the command line.</param>
    /// <param name="destination">The destination.</param>
    /// <param name="error">The reason why the text is not a destination.</param>
    public static bool TryParse(string text, [NotNullWhen(true)] out Destination? destination, [NotNullWhen(false)] out string? error)
    {
        (destination, error) = (null, null);
        try
        {
            (_, _, Func<string, Destination>? parse) = Array.Find(Schemes, scheme => scheme.IsMeant(text));
            destination = parse is null ? throw new FormatException($"'{HiddenPassword.In(text)}' is not a destination. Use {Forms}.") : parse(text);
            return true;
        }
        catch (FormatException fault)
        {
            error = fault.Message;
            return false;
        }
    }

    /// <summary>Whether another argument means the same place.</summary>
    public abstract bool IsSame(Destination other);

    /// <summary>Starts to send what the reader receives.</summary>
    /// <param name="reader">The reader, which has not started yet.</param>
    /// <param name="overwrite">Whether an existing file is replaced.</param>
    /// <exception cref="RelayException">The destination is not available.</exception>
    public abstract Outlet Open(NeuronReader reader, bool overwrite);

    private static Func<string, bool> StartsWith(string scheme) => text => text.StartsWith(scheme, StringComparison.OrdinalIgnoreCase);
}

/// <summary>The exception for a destination that is not available: exit code 1. The message starts with the argument.</summary>
internal sealed class RelayException(string message) : Exception(message);
