using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.View.Takes;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.Tests.View.Takes;

/// <summary>Opens files as takes, in a folder of their own.</summary>
internal sealed class OpenTakes : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly ScratchFolder _scratch = new(long.MaxValue);

    public OpenTakes() => Library = new TakeLibrary(_scratch, run: "t", uploadRoom: long.MaxValue);

    public TakeLibrary Library { get; }

    public TemporaryFolder Folder => _folder;

    /// <summary>Files in the folder for temporary files.</summary>
    public int ScratchFiles => Directory.GetFiles(_scratch.Path).Length;

    /// <summary>Opens a file and waits until it was read.</summary>
    public async Task<Take> OpenAsync(string path, RotationOrder? order = null)
    {
        Take take = Library.Open(path, Path.GetFileName(path), order: order);
        await take.Completion;
        return take;
    }

    /// <summary>Writes a recording of frames of the simulator's actor.</summary>
    /// <param name="frames">Times in milliseconds and numbers of frames, for each avatar.</param>
    /// <param name="metadata">The metadata.</param>
    /// <param name="order">The rotation order of the stream.</param>
    public string Record(IEnumerable<(double Milliseconds, int Avatar, int Frame)> frames, RecordingMetadata? metadata = null, RotationOrder order = RotationOrder.YXZ)
    {
        string path = _folder["take.nmrec"];
        using RecordingWriter writer = RecordingWriter.Create(path, metadata);
        writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, "127.0.0.1:50000", "127.0.0.1:7001"));
        foreach ((double milliseconds, int avatar, int frame) in frames)
            writer.WriteBytes(TimeSpan.FromMilliseconds(milliseconds), 0, Packet(avatar, frame, order));

        return path;
    }

    /// <summary>The pose of an avatar in a frame. The second avatar is half as tall as the first.</summary>
    public static void GetPose(int avatar, int frame, Span<BoneTransform> pose)
    {
        new SyntheticSource(60).GetPose(frame, pose);
        foreach (ref BoneTransform bone in pose)
            bone = bone with { Position = bone.Position / (avatar + 1) };
    }

    private static byte[] Packet(int avatar, int frame, RotationOrder order)
    {
        var layout = new ChannelLayout(hasDisplacement: true, hasReference: false);
        float[] values = new float[layout.ValueCount];
        new Half(avatar).WriteValues(frame, layout, order, values);
        var header = new MotionHeader { AvatarIndex = avatar, AvatarName = new AvatarName($"Actor {avatar}"), FrameIndex = (uint)frame, HasDisplacement = true, ValueCount = values.Length };
        byte[] packet = new byte[header.PacketSize];
        PacketEncoder.WriteMotion(packet, header, values);
        return packet;
    }

    public void Dispose()
    {
        Library.Dispose();
        _scratch.Dispose();
        _folder.Dispose();
    }

    private sealed class Half(int avatar) : MotionSource
    {
        public override double FrameRate => 60;

        public override long? FrameCount => null;

        public override bool HasDisplacement => true;

        public override void GetPose(long frame, Span<BoneTransform> pose) => OpenTakes.GetPose(avatar, (int)frame, pose);

        public override FootContacts GetFootContacts(long frame) => default;
    }
}
