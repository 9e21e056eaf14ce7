using System.Net;
using NeuronMocap.Commands;

namespace NeuronMocap.Tool.Arguments;

/// <summary>The computer and port of a server.</summary>
/// <param name="Host">A name or an address, without brackets.</param>
/// <param name="Port">1 to 65535.</param>
internal readonly record struct ServerAddress(string Host, int Port)
{
    public static ServerAddress Of(IPEndPoint endPoint) => new(endPoint.Address.ToString(), endPoint.Port);

    /// <summary>Parses the address of a stream.</summary>
    /// <exception cref="FormatException">The text is not the address of a server. The message says why.</exception>
    public static ServerAddress Parse(string text)
    {
        var options = NeuronReaderOptions.Parse(text);
        return options.Transport == TransportKind.Tcp
            ? new ServerAddress(options.Host, options.Port)
            : throw new FormatException($"'{text}' is a port of this computer. Use HOST or HOST:PORT.");
    }

    /// <summary>Parses the address of a command channel, which has a different default port.</summary>
    /// <inheritdoc cref="Parse"/>
    public static ServerAddress ParseCommandChannel(string text)
    {
        var options = NeuronCommandOptions.Parse(text);
        return new ServerAddress(options.Host, options.Port);
    }

    /// <summary>Parses a destination of datagrams, HOST:PORT. It has no default port.</summary>
    /// <exception cref="FormatException">The text is not an address, or has no port. The message says which.</exception>
    public static ServerAddress ParseDestination(string text)
    {
        // A complete address is equal to its text.
        ServerAddress address = Parse(text);
        return address.ToString().Equals(text.Trim(), StringComparison.Ordinal)
            ? address
            : throw new FormatException($"'{text}' is not of the form HOST:PORT.");
    }

    /// <summary>The address with its port. An IPv6 address is in brackets.</summary>
    public override string ToString() => Host.Contains(':', StringComparison.Ordinal) ? $"[{Host}]:{Port}" : $"{Host}:{Port}";
}
