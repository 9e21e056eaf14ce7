using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Playback;

/// <summary>Files for playback, deleted with the test.</summary>
internal sealed class TemporaryFile : IDisposable
{
    public TemporaryFile(byte[]? content = null, string extension = ".nmrec")
    {
        Path = System.IO.Path.Combine(System.IO.Path.GetTempPath(), System.IO.Path.GetRandomFileName() + extension);
        if (content is not null)
            File.WriteAllBytes(Path, content);
    }

    public string Path { get; }

    public void Dispose() => File.Delete(Path);
}

internal static class Recordings
{
    /// <summary>A recording of one TCP connection: pieces with their times in milliseconds. It is closed at the end.</summary>
    public static TemporaryFile OfTcp(params (double Milliseconds, byte[] Bytes)[] pieces) => Write(writer =>
    {
        writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, "127.0.0.1:50000", "127.0.0.1:7001"));
        foreach ((double milliseconds, byte[] bytes) in pieces)
            writer.WriteBytes(At(milliseconds), 0, bytes);

        writer.CloseConnection(At(pieces[^1].Milliseconds), 0, "closed");
    });

    public static TemporaryFile Write(Action<RecordingWriter> write, RecordingMetadata? metadata = null)
    {
        var file = new TemporaryFile();
        using (RecordingWriter writer = RecordingWriter.Create(file.Path, metadata))
            write(writer);

        return file;
    }

    public static TimeSpan At(double milliseconds) => TimeSpan.FromTicks((long)(milliseconds * TimeSpan.TicksPerMillisecond));

    /// <summary>A frame as one line: kind, avatar, index and all bits.</summary>
    public static string Describe(AvatarFrame frame)
    {
        var hash = new HashCode();
        foreach (float value in frame.Values)
            hash.Add(BitConverter.SingleToInt32Bits(value));

        return $"{frame.GetType().Name} {frame.Sender} {frame.AvatarIndex} {frame.AvatarName} {frame.FrameIndex} {frame.Values.Length} {hash.ToHashCode():X8}";
    }
}
