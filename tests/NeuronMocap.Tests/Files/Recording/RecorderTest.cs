using System.Diagnostics;
using System.Net;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Recording;

// The recorder without a reader: a test pushes numbered pieces into it.
public abstract class RecorderTest : IDisposable
{
    private protected const int PieceSize = 1000;

    private protected static readonly IPEndPoint Local = new(IPAddress.Loopback, 50000);
    private protected static readonly IPEndPoint Remote = new(IPAddress.Loopback, 7001);

    private readonly byte[] _piece = new byte[PieceSize];

    private protected RecorderTest() => Tap.Open(isDatagrams: false, Local, Remote, Stopwatch.GetTimestamp());

    private protected RecordingFolder Folder { get; } = new();

    private protected StreamTap Tap { get; } = new();

    private protected int Sent { get; private set; }

    public void Dispose()
    {
        Folder.Dispose();
        GC.SuppressFinalize(this);
    }

    private protected void Push()
    {
        BitConverter.TryWriteBytes(_piece, Sent++);
        Tap.OnBytes(0, [], new ArraySegment<byte>(_piece), Stopwatch.GetTimestamp());
    }

    // A file of a megabyte fills quickly, so it pushes many pieces at each check.
    private protected Task PushUntilAsync(Func<bool> condition) => Limits.UntilAsync(() =>
    {
        for (int i = 0; i < 100 && !condition(); i++)
            Push();

        return condition();
    });

    private protected StreamRecorder Start(RecordingOptions options, Stream stream) => Start(options, _ => stream);

    private protected StreamRecorder Start(RecordingOptions options, Func<string, Stream> open) =>
        new("take.nmrec", options, RecordingMetadata.Empty, Tap, static _ => { }, (path, _) => open(path));
}
