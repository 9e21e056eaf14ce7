using System.Net;
using System.Net.Sockets;
using System.Text;
using Microsoft.AspNetCore.Builder;
using NeuronMocap.Gltf;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Listening;
using NeuronMocap.Tool.View.Control;
using NeuronMocap.Tool.View.Live;
using NeuronMocap.Tool.View.Performers;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View;

/// <summary>
/// Makes what the first page needs once, on another processor while the program starts. .NET compiles each method when it is first called: without this,
/// the first page waits for it.
/// </summary>
internal static class FirstUse
{
    private static readonly TimeSpan LongestRequest = TimeSpan.FromMinutes(1);
    private static readonly IPEndPoint Unused = new(IPAddress.Loopback, 0);

    private static int _hasStarted;

    /// <summary>Starts once in a process. On a single processor, it would only delay the program.</summary>
    public static void Start()
    {
        if (Environment.ProcessorCount > 1 && Interlocked.Exchange(ref _hasStarted, 1) == 0)
            _ = Task.Run(static () => RunAsync(Unused));
    }

    /// <summary>Requests the page, and makes the messages of a performer and a figure. A request that fails is no fault: the first page takes longer.</summary>
    /// <param name="endPoint">Where a server for this request listens.</param>
    public static async Task RunAsync(IPEndPoint endPoint)
    {
        Task request = RequestPageAsync(endPoint);
        MakeMessages();
        try
        {
            await request;
        }
        catch (Exception exception) when (exception is BroadcasterException or IOException or SocketException or OperationCanceledException)
        {
            // Some computers do not let programs connect to themselves.
        }
    }

    /// <summary>
    /// Requests the page as a browser does, through sockets, the guard and the routes. The server for it has nothing but the files of the page, and only this
    /// computer can reach it.
    /// </summary>
    /// <param name="endPoint">Where the server listens.</param>
    /// <returns>The answer.</returns>
    public static async Task<byte[]> RequestPageAsync(IPEndPoint endPoint)
    {
        using var limit = new CancellationTokenSource(LongestRequest);
        await using WebListener listener = WebListener.Create(endPoint);
        listener.Application.UseGuard(new AccessPolicy(token: null, isRandom: false, isPublic: false, origins: []));
        listener.Application.UseRouting();
        PageFiles.Map(listener.Application);
        listener.Start();
        using var client = new TcpClient();
        await client.ConnectAsync(listener.LocalEndPoint, limit.Token);
        NetworkStream stream = client.GetStream();
        await stream.WriteAsync(Encoding.ASCII.GetBytes($"GET / HTTP/1.1\r\nHost: {listener.LocalEndPoint}\r\nAccept-Encoding: gzip\r\nConnection: close\r\n\r\n"), limit.Token);
        using var answer = new MemoryStream();
        await stream.CopyToAsync(answer, limit.Token);
        return answer.ToArray();
    }

    private static void MakeMessages()
    {
        var performer = new Performer(default, string.Empty, Index: 0, SkeletonBody.GetDefault());
        PerformerJson json = performer.ToJson();
        var figures = new PerformerFigures(json.Key, Fps: 0, Latency: 0, Jitter: 0, Lost: 0, Dropped: 0);
        object[] messages =
        [
            new HelloJson(string.Empty, string.Empty, string.Empty, string.Empty, Take: null, CanCommand: false, UploadLimit: 0, [json]),
            new PerformerMessage(json),
            new ContactMessage(json.Key, Left: false, Right: false),
            new StatusMessage(string.Empty, string.Empty, string.Empty, string.Empty, [figures], BytesPerSecond: 0, Reconnects: 0),
        ];
        foreach (object message in messages)
            ApiJson.ToBytes(message);

        GlbWriter.CreateFigure(performer.Body, performer.Name, accentColor: 0);
    }
}
