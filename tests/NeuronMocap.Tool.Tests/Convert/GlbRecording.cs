using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Gltf;

namespace NeuronMocap.Tool.Tests.Convert;

/// <summary>Records frames of the simulator's actor, for any avatar at any time.</summary>
internal sealed class GlbRecording : IDisposable
{
    private static readonly ChannelLayout Layout = new(hasDisplacement: true, hasReference: false);
    private static readonly SyntheticSource Actor = new(GlbTake.Rate);

    private readonly RecordingWriter _writer;
    private readonly float[] _values = new float[Layout.ValueCount];

    public GlbRecording(string path)
    {
        _writer = RecordingWriter.Create(path, RecordingMetadata.Empty.With(RecordingMetadata.RotationOrderKey, "YXZ"));
        _writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, string.Empty, string.Empty));
    }

    /// <summary>Adds a frame. The pose is that of the actor at the frame's index.</summary>
    public void Add(double seconds, int index, int avatar = 0, string name = "Anna", Action<float[]>? change = null)
    {
        Actor.WriteValues(index, Layout, RotationOrder.YXZ, _values);
        change?.Invoke(_values);
        var header = new MotionHeader
        {
            ValueCount = _values.Length,
            HasDisplacement = true,
            AvatarIndex = avatar,
            AvatarName = new AvatarName(name),
            FrameIndex = (uint)index,
        };
        byte[] packet = new byte[header.PacketSize];
        _writer.WriteBytes(TimeSpan.FromSeconds(seconds), 0, packet.AsSpan(0, PacketEncoder.WriteMotion(packet, header, _values)));
    }

    public void Dispose() => _writer.Dispose();
}
