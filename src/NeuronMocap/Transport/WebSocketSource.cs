using System.Net.Sockets;
using System.Net.WebSockets;
using System.Security.Authentication;
using NeuronMocap.Transport;

namespace NeuronMocap;

/// <summary>
/// Receives from a WebSocket server of the package NeuronMocap.AspNetCore, or of <c>neuron-mocap relay … ws://:PORT</c>: whole packets, bit for bit.
/// Set it as <see cref="NeuronReaderOptions.Source"/>.
/// </summary>
/// <remarks>
/// A proxy of the web can stand between, and <c>wss://</c> encrypts the connection; the system then checks the certificate. A server that is too fast
/// for the connection leaves out older frames, so the frame numbers can have gaps.
/// </remarks>
public sealed class WebSocketSource : ByteSource
{
    /// <summary>The subprotocol in which each message is one packet.</summary>
    internal const string Packets = "packet";

    private const int SwitchingProtocols = 101;

    private static readonly TimeSpan LongestTimeout = TimeSpan.FromMinutes(5);

    private readonly string? _token;
    private readonly TimeSpan _connectTimeout = TimeSpan.FromSeconds(5);

    /// <summary>Creates a source without connecting.</summary>
    /// <param name="address">The address of the server: <c>ws://</c> or <c>wss://</c>, a host, and usually a port.</param>
    /// <param name="token">
    /// The word that the server asks for; null for none. It is sent in the header <c>Authorization</c>. Write a word that is not all ASCII
    /// into the query of the address, percent-encoded: <c>?token=w%C3%B6rd</c>.
    /// </param>
    /// <exception cref="ArgumentException">
    /// The address has another scheme or is not absolute, or the token is empty, has spaces around it, or is not all ASCII.
    /// </exception>
    public WebSocketSource(Uri address, string? token = null)
    {
        ArgumentNullException.ThrowIfNull(address);
        if (!address.IsAbsoluteUri || address.Scheme is not ("ws" or "wss"))
            throw new ArgumentException($"'{address}' is not the address of a WebSocket. Use ws://HOST:PORT or wss://HOST:PORT.", nameof(address));
        if (token is not null && (token.Length == 0 || token.Trim().Length < token.Length || token.Any(static character => character is < ' ' or > '~')))
            throw new ArgumentException("The token must be null, or ASCII characters without spaces around them. Other characters go into the query: ?token=w%C3%B6rd.", nameof(token));

        Address = address;
        _token = token;
    }

    /// <summary>The address of the server.</summary>
    public Uri Address { get; }

    /// <summary>Longest time to wait for the server: more than zero, at most 5 minutes. The default is 5 s.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is out of range.</exception>
    public TimeSpan ConnectTimeout
    {
        get => _connectTimeout;
        init => _connectTimeout = value > TimeSpan.Zero && value <= LongestTimeout
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The timeout must be more than zero and at most 5 minutes.");
    }

    /// <summary>The address without its query, which may hold a token.</summary>
    public override string Name => Address.GetLeftPart(UriPartial.Path).TrimEnd('/');

    /// <summary>Connects to the server.</summary>
    /// <param name="cancellationToken">Cancelled when the reader stops.</param>
    /// <returns>The bytes of all packets that the server sends.</returns>
    /// <exception cref="NeuronConnectionException">The server did not answer in time, or it refused the connection. The message says why.</exception>
    public override async ValueTask<Stream> OpenAsync(CancellationToken cancellationToken)
    {
        var socket = new ClientWebSocket();
        using var timeoutSource = CancellationTokenSource.CreateLinkedTokenSource(cancellationToken);
        timeoutSource.CancelAfter(ConnectTimeout);
        try
        {
            HandshakeAnswer.Collect(socket);
            socket.Options.AddSubProtocol(Packets);
            if (_token is not null)
                socket.Options.SetRequestHeader("Authorization", $"Bearer {_token}");

            await WebSocketConnect.ConnectAsync(socket, Address, timeoutSource.Token).ConfigureAwait(false);
            return new WebSocketStream(socket, Name);
        }
        catch (Exception exception)
        {
            int? answer = HandshakeAnswer.Of(socket);
            socket.Dispose();
            if (timeoutSource.IsCancellationRequested && !cancellationToken.IsCancellationRequested)
                throw new NeuronConnectionException(ConnectionReason.TimedOut, FormattableString.Invariant($"The server did not answer within {ConnectTimeout.TotalSeconds:0.#} s."));
            if (exception is WebSocketException failure)
                throw Describe(answer, failure);

            throw;
        }
    }

    private NeuronConnectionException Describe(int? answer, WebSocketException failure)
    {
        (ConnectionReason reason, string text) = answer switch
        {
            400 => (ConnectionReason.Refused, "The server does not accept the request; check the query, such as rate."),
            401 => (ConnectionReason.AccessDenied, _token is null && Address.Query.Length == 0 ? "The server wants a token." : "The token is wrong."),
            403 => (ConnectionReason.AccessDenied, "The server does not allow this client."),
            404 => (ConnectionReason.Refused, "There is no motion at this path. Check the address."),
            503 => (ConnectionReason.Refused, "The server has no room for another client, or its stream has ended."),
            { } code and not SwitchingProtocols => (ConnectionReason.Refused, $"The server answers with status {code}. It may not be a server of motion."),
            _ => DescribeCause(failure),
        };
        return new NeuronConnectionException(reason, text);
    }

    // Without an answer of a web server.
    private (ConnectionReason Reason, string Text) DescribeCause(WebSocketException failure)
    {
        Exception cause = failure.GetBaseException();
        ConnectionReason reason = cause is SocketException socket ? SocketErrors.ToReason(socket.SocketErrorCode) : ConnectionReason.NetworkError;
        return reason switch
        {
            ConnectionReason.Refused => (reason, "Nothing listens on this port."),
            ConnectionReason.HostNotFound => (reason, $"The host name '{Address.Host}' has no address. Check its spelling."),
            ConnectionReason.Unreachable => (reason, "No route leads to the server. Check the address and the network."),
            _ when cause is SocketException or AuthenticationException || failure.InnerException is null => (reason, $"{cause.Message.TrimEnd('.')}."),
            _ => (reason, "There is no web server on this port."),
        };
    }
}
