using System.Diagnostics;
using NeuronMocap.Recording;
using NeuronMocap.Tests.Recording;

namespace NeuronMocap.Tests.Playback;

// Playback seeks, which a pipe cannot do.
public sealed class PipePlaybackTests : IDisposable
{
    private static readonly Dictionary<string, Action<string>> Openers = new()
    {
        ["player"] = static path => RecordingPlayer.Open(path).Dispose(),
        ["frame reader"] = static path => RecordedFrameReader.Open(path).Dispose(),
        ["recording reader"] = static path => RecordingReader.Open(path).Dispose(),
        ["dump"] = static path =>
        {
            using var writer = new RecordingWriter(new MemoryStream());
            RawDump.CopyTo(path, writer);
        },
    };

    private readonly RecordingFolder _folder = new();

    public static TheoryData<string> Kinds => [.. Openers.Keys];

    public void Dispose() => _folder.Dispose();

    [Theory, MemberData(nameof(Kinds))]
    public void A_pipe_is_refused(string kind)
    {
        Assert.SkipUnless(InstalledPrograms.Have("mkfifo"), "No mkfifo.");
        string path = _folder.PathOf("pipe");
        using (Process making = Process.Start("mkfifo", [path]))
            making.WaitForExit();

        // Opening one end of a pipe waits for the other end, unless one program has both.
        using var both = new FileStream(path, FileMode.Open, FileAccess.ReadWrite, FileShare.ReadWrite);
        IOException refused = Assert.Throws<IOException>(() => Openers[kind](path));
        Assert.Contains(path, refused.Message, StringComparison.Ordinal);
        Assert.Contains("pipe", refused.Message, StringComparison.Ordinal);
    }
}
