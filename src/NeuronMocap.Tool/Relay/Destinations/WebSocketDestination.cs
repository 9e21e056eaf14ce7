using System.Net;
using NeuronMocap.AspNetCore;
using NeuronMocap.Server;
using NeuronMocap.Tool.Simulate;

namespace NeuronMocap.Tool.Relay.Destinations;

/// <summary>ws://[ADDRESS]:PORT: listens for browsers and other WebSocket clients.</summary>
/// <param name="Text">The argument of the command line.</param>
/// <param name="EndPoint">Address and port to listen on. Without an address, only this computer can connect.</param>
internal sealed record WebSocketDestination(string Text, IPEndPoint EndPoint) : Destination(Text)
{
    public const string Scheme = "ws://";

    /// <summary>The word that clients must send; null for none.</summary>
    public string? Token { get; init; }

    /// <summary>The web sites whose pages may connect.</summary>
    public IReadOnlyList<string> AllowedOrigins { get; init; } = [];

    public override IPEndPoint Listening => EndPoint;

    public static WebSocketDestination Parse(string text) => new(text, TcpDestination.ParseListening(text, Scheme, IPAddress.Loopback));

    public override bool IsSame(Destination other) => other is WebSocketDestination web && TcpDestination.Clashes(EndPoint, web.EndPoint);

    public override Outlet Open(NeuronReader reader, bool overwrite)
    {
        try
        {
            return WebSocketOutlet.Start(reader, EndPoint, new WebSocketBroadcasterOptions { Token = Token, AllowedOrigins = AllowedOrigins });
        }
        catch (BroadcasterException failure)
        {
            throw new RelayException(StartFailure.DescribeArgument(failure, Text, EndPoint));
        }
    }
}
