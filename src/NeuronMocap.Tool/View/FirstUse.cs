using System.Net;
using NeuronMocap.Gltf;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Listening;
using NeuronMocap.Tool.View.Control;
using NeuronMocap.Tool.View.Live;
using NeuronMocap.Tool.View.Performers;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View;

/// <summary>
/// Makes what the first page needs once, on another processor while the program starts. Without this, the first page waits while .NET
/// compiles each method on its first call.
/// </summary>
internal static class FirstUse
{
    private static int _hasStarted;

    /// <summary>Starts once in a process. On a single processor, it would only delay the program.</summary>
    public static void Start()
    {
        if (Environment.ProcessorCount > 1 && Interlocked.Exchange(ref _hasStarted, 1) == 0)
            _ = Task.Run(RunAsync);
    }

    /// <summary>Makes a web server that does not listen, the messages of a performer, and a figure.</summary>
    public static async Task RunAsync()
    {
        WebListener listener = WebListener.Create(new IPEndPoint(IPAddress.Loopback, 0));
        await listener.Application.DisposeAsync();
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
