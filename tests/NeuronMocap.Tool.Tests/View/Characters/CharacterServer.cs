using System.Net.WebSockets;
using System.Text;
using System.Text.Json;
using System.Text.Json.Nodes;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.View;
using NeuronMocap.Tool.View.Characters;
using NeuronMocap.Tool.View.Control;
using NeuronMocap.Tool.View.Live;
using NeuronMocap.Tool.View.Takes;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.Tests.View.Characters;

/// <summary>A server of the page with a stream of its own, and the requests of a page.</summary>
internal sealed class CharacterServer : IAsyncDisposable
{
    private static readonly TimeSpan Limit = TimeSpan.FromSeconds(60);

    private readonly NeuronReader _reader;
    private readonly ControlHub _hub;
    private readonly LiveSession _live;
    private readonly ViewServer _server;
    private readonly HttpClient _http;
    private readonly ScratchFolder _scratch;

    private CharacterServer(
        NeuronReader reader, ControlHub hub, LiveSession live, ScratchFolder scratch, ITakeLibrary takes, CharacterLibrary library, ViewServer server)
    {
        (_reader, _hub, _live, _scratch, Takes, Library, _server) = (reader, hub, live, scratch, takes, library, server);
        _http = new HttpClient(new SocketsHttpHandler { Expect100ContinueTimeout = Limit }) { BaseAddress = new Uri($"http://{server.LocalEndPoint}/"), Timeout = Limit };
    }

    public CharacterLibrary Library { get; }

    public ITakeLibrary Takes { get; }

    /// <summary>The frames that were taken from the reader for characters.</summary>
    public long FramesTaken => _live.Motion.FramesTaken;

    /// <summary>Shows what a server sends.</summary>
    public static async Task<CharacterServer> StartAsync(System.Net.IPEndPoint source)
    {
        var reader = new NeuronReader(new NeuronReaderOptions { Host = source.Address.ToString(), Port = source.Port });
        LiveSession? live = null;
        var hub = new ControlHub(() => [.. live!.Greet()]);
        live = new LiveSession(reader, "test", hub);
        var scratch = new ScratchFolder(BodyLimit.Megabyte);
        var takes = new TakeService(scratch, hub, uploadMegabytes: 1, run: "t");
        var library = new CharacterLibrary(live, takes);
        reader.Start();
        var options = new ViewOptions(Source.Demo, new ConnectionOptions()) { Port = 0 };
        return new CharacterServer(reader, hub, live, scratch, takes, library, await ViewServer.StartAsync(options, [hub, live, takes, library]));
    }

    public static JsonObject Request(CharacterNode[] nodes, string performer = "0-0") => new()
    {
        ["name"] = "test.glb",
        ["performer"] = performer,
        ["nodes"] = new JsonArray([.. nodes.Select(static node => new JsonObject
        {
            ["name"] = node.Name,
            ["parent"] = node.Parent,
            ["translation"] = new JsonArray(node.Translation.X, node.Translation.Y, node.Translation.Z),
            ["rotation"] = new JsonArray(node.Rotation.X, node.Rotation.Y, node.Rotation.Z, node.Rotation.W),
            ["scale"] = new JsonArray(node.Scale.X, node.Scale.Y, node.Scale.Z),
        })]),
    };

    public async Task<(int Status, JsonElement Body)> SendAsync(HttpMethod method, string path, JsonNode? body = null)
    {
        using var request = new HttpRequestMessage(method, path);
        if (body is not null)
            request.Content = new StringContent(body.ToJsonString(), Encoding.UTF8, "application/json");

        // The server closes the connection when it refuses a body. Its answer could be lost while the client still sends, so the client asks first.
        request.Headers.ExpectContinue = body is not null;
        using HttpResponseMessage answer = await _http.SendAsync(request, TestContext.Current.CancellationToken);
        byte[] bytes = await answer.Content.ReadAsByteArrayAsync(TestContext.Current.CancellationToken);
        return ((int)answer.StatusCode, bytes.Length == 0 ? default : JsonDocument.Parse(bytes).RootElement);
    }

    public Task<byte[]> GetBytesAsync(string path) => _http.GetByteArrayAsync(path, TestContext.Current.CancellationToken);

    /// <summary>Adds a character, and returns its number.</summary>
    public async Task<uint> AddAsync(CharacterNode[] nodes, string performer = "0-0")
    {
        (int status, JsonElement body) = await SendAsync(HttpMethod.Post, "api/characters", Request(nodes, performer));
        Assert.Equal(200, status);
        return body.GetProperty("id").GetUInt32();
    }

    public async Task<ClientWebSocket> ListenAsync(uint id)
    {
        var socket = new ClientWebSocket();
        await socket.ConnectAsync(new Uri($"ws://{_server.LocalEndPoint}/characters/{id}/motion"), TestContext.Current.CancellationToken).WaitAsync(Limit);
        return socket;
    }

    /// <summary>Receives a pose; empty if the server ends the connection.</summary>
    public static async Task<byte[]> ReceiveAsync(ClientWebSocket socket)
    {
        byte[] buffer = new byte[1024];
        WebSocketReceiveResult result = await socket.ReceiveAsync(buffer, TestContext.Current.CancellationToken).WaitAsync(Limit);
        Assert.True(result.EndOfMessage);
        return result.MessageType == WebSocketMessageType.Close ? [] : buffer[..result.Count];
    }

    public static async Task UntilAsync(Func<bool> condition, string what)
    {
        long start = System.Diagnostics.Stopwatch.GetTimestamp();
        while (!condition())
        {
            Assert.True(System.Diagnostics.Stopwatch.GetElapsedTime(start) < Limit, $"This did not happen: {what}.");
            await Task.Delay(5, TestContext.Current.CancellationToken);
        }
    }

    public async ValueTask DisposeAsync()
    {
        _http.Dispose();
        await _server.DisposeAsync();
        await Library.DisposeAsync();
        await Takes.DisposeAsync();
        await _reader.DisposeAsync();
        await _live.DisposeAsync();
        await _hub.DisposeAsync();
        _scratch.Dispose();
    }
}
