using NeuronMocap.Recording;

namespace NeuronMocap.Tool.Convert;

/// <summary>Receives the packets of a stream that is created from a file.</summary>
internal interface IPacketSink : IDisposable
{
    void Write(TimeSpan time, ReadOnlySpan<byte> packet);
}

/// <summary>Writes only the bytes, one packet after the other.</summary>
internal sealed class RawSink(Stream stream) : IPacketSink
{
    public void Write(TimeSpan time, ReadOnlySpan<byte> packet) => stream.Write(packet);

    public void Dispose() => stream.Dispose();
}

/// <summary>Writes a recording, as if the packets had arrived over one TCP connection.</summary>
internal sealed class RecordingSink : IPacketSink
{
    private readonly RecordingWriter _writer;

    public RecordingSink(RecordingWriter writer)
    {
        _writer = writer;
        _writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, string.Empty, string.Empty));
    }

    public void Write(TimeSpan time, ReadOnlySpan<byte> packet) => _writer.WriteBytes(time, 0, packet);

    public void Dispose()
    {
        _writer.CloseConnection(_writer.Duration, 0, "The file ends.");
        _writer.Dispose();
    }
}
