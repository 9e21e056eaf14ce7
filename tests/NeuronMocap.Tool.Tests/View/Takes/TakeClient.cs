using System.Buffers.Binary;
using System.Globalization;
using System.Net;
using System.Text.Json;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.View;
using NeuronMocap.Tool.View.Control;
using NeuronMocap.Tool.View.Takes;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.Tests.View.Takes;

/// <summary>A server with takes, and what a page asks of it.</summary>
internal sealed class TakeClient : IAsyncDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly ScratchFolder _scratch;
    private readonly ControlHub _hub;
    private readonly TakeService _takes;
    private readonly ViewServer _server;
    private readonly HttpClient _http;

    private TakeClient(TakeService takes, ViewServer server, ScratchFolder scratch, ControlHub hub)
    {
        (_takes, _server, _scratch, _hub) = (takes, server, scratch, hub);
        _http = new HttpClient { BaseAddress = new Uri($"http://{server.LocalEndPoint}/api/") };
    }

    public TemporaryFolder Folder => _folder;

    public int ScratchFiles => Directory.GetFiles(_scratch.Path).Length;

    public static async Task<TakeClient> StartAsync(int megabytes = 512)
    {
        var scratch = new ScratchFolder(long.MaxValue);
        var hub = new ControlHub(static () => [new object()]);
        var takes = new TakeService(scratch, hub, megabytes, run: "t");
        var options = new ViewOptions(Source.Demo, new ConnectionOptions()) { Port = 0, Bind = IPAddress.Loopback };
        return new TakeClient(takes, await ViewServer.StartAsync(options, [hub, takes]), scratch, hub);
    }

    /// <summary>Sends a file and waits until the server has read it.</summary>
    public async Task<JsonElement> UploadAsync(string path)
    {
        JsonElement answer = await PostAsync(Path.GetFileName(path), await File.ReadAllBytesAsync(path));
        return await WaitAsync(answer.GetProperty("id").GetString()!);
    }

    public async Task<JsonElement> PostAsync(string name, byte[] bytes, HttpStatusCode expected = HttpStatusCode.OK)
    {
        using HttpResponseMessage answer = await _http.PostAsync($"takes?name={Uri.EscapeDataString(name)}", new ByteArrayContent(bytes));
        return await ReadAsync(answer, expected);
    }

    public async Task<JsonElement> GetAsync(string address, HttpStatusCode expected = HttpStatusCode.OK)
    {
        using HttpResponseMessage answer = await _http.GetAsync(address);
        return await ReadAsync(answer, expected);
    }

    public Task<HttpResponseMessage> GetFileAsync(string address) => _http.GetAsync(address);

    /// <summary>Opens a file of this computer.</summary>
    public async Task<JsonElement> OpenAsync(string path) => await WaitAsync(await _takes.OpenAsync(path, order: null, CancellationToken.None));

    /// <summary>Gets poses, without their lengths.</summary>
    public async Task<List<byte[]>> GetPosesAsync(string id, string performer, long from, int count)
    {
        byte[] bytes = await _http.GetByteArrayAsync(string.Create(CultureInfo.InvariantCulture, $"takes/{id}/poses?performer={performer}&from={from}&count={count}"));
        var poses = new List<byte[]>();
        for (int place = 0; place < bytes.Length;)
        {
            int length = (int)BinaryPrimitives.ReadUInt32LittleEndian(bytes.AsSpan(place));
            poses.Add(bytes[(place + sizeof(uint))..(place + sizeof(uint) + length)]);
            place += sizeof(uint) + length;
        }

        return poses;
    }

    public async ValueTask DisposeAsync()
    {
        _http.Dispose();
        await _server.DisposeAsync();
        await _takes.DisposeAsync();
        await _hub.DisposeAsync();
        _scratch.Dispose();
        _folder.Dispose();
    }

    /// <summary>Waits until the server has read a take.</summary>
    public async Task<JsonElement> WaitAsync(string id)
    {
        using var limit = new CancellationTokenSource(TimeSpan.FromMinutes(2));
        while (true)
        {
            JsonElement info = await GetAsync($"takes/{id}");
            if (info.GetProperty("progress").GetDouble() == 1)
                return info;

            limit.Token.ThrowIfCancellationRequested();
            await Task.Yield();
        }
    }

    private static async Task<JsonElement> ReadAsync(HttpResponseMessage answer, HttpStatusCode expected)
    {
        string text = await answer.Content.ReadAsStringAsync();
        Assert.True(answer.StatusCode == expected, $"{(int)answer.StatusCode}: {text}");
        return JsonDocument.Parse(text).RootElement;
    }
}
