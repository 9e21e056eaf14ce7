using NeuronMocap.Bvh;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Sources;

/// <summary>
/// Files follow the time of the game, live motion follows real time. In the takes here, the hips move by one centimetre in each of 60 frames a second.
/// </summary>
public sealed class GameTimeTests : SourceFixture
{
    private static readonly ChannelLayout Layout = new(hasDisplacement: true, hasReference: false);

    private readonly string _folder = Directory.CreateTempSubdirectory("neuron-unity").FullName;

    public override void Dispose()
    {
        base.Dispose();
        Directory.Delete(_folder, recursive: true);
        GC.SuppressFinalize(this);
    }

    [Theory]
    [InlineData(SourceKind.BvhFile, 30)]
    [InlineData(SourceKind.BvhFile, 10)]
    [InlineData(SourceKind.Recording, 30)]
    [InlineData(SourceKind.Recording, 10)]
    public void A_capture_has_every_frame_of_a_file(SourceKind kind, int captureFramerate)
    {
        Performer performer = Play(kind);
        Time.captureFramerate = captureFramerate;
        Loop.Frames(10, 0.5f);
        for (int i = 0; i < 30; i++)
        {
            float before = Travelled(performer);
            Loop.Frame(i % 2 == 0 ? 0.001f : 0.5f);
            Assert.Equal(60f / captureFramerate, Travelled(performer) - before, 0.02f);
        }

        Assert.True(performer.IsLive);
    }

    [Theory]
    [InlineData(SourceKind.BvhFile)]
    [InlineData(SourceKind.Recording)]
    public void A_file_stops_and_slows_down_with_the_game(SourceKind kind)
    {
        Performer performer = Play(kind);

        // A capture waits for frames that are read late. Without one, a busy computer would show them later.
        Time.captureFramerate = 30;
        Loop.Frames(10);
        Time.timeScale = 0;
        Loop.Frame();
        float before = Travelled(performer);
        Loop.Frames(100, 0.1f);
        Assert.Equal(before, Travelled(performer), 0.001f);
        Assert.True(performer.IsLive);

        Time.timeScale = 0.5f;
        Loop.Frames(20);
        Assert.Equal(20, Travelled(performer) - before, 0.05f);
    }

    [Fact]
    public void A_file_ends_in_the_time_of_the_game()
    {
        Play(SourceKind.BvhFile, loop: false);
        MocapSource source = MocapSource.All[0];
        Time.captureFramerate = 1;
        Loop.Frames(45);
        Assert.Equal(SourceState.Receiving, source.State);

        Loop.Frames(10);
        Loop.RunUntil(() => source.State == SourceState.Ended);
    }

    [Fact]
    public void Live_motion_follows_real_time()
    {
        MocapSource source = Add(Serve(Walk()));
        Performer performer = WaitForPose(source);
        Time.timeScale = 0;
        float before = Travelled(performer);
        Loop.RunUntil(() => Travelled(performer) - before > 10);
    }

    [Theory]
    [InlineData(SourceKind.BvhFile)]
    [InlineData(SourceKind.Recording)]
    public void A_rendered_frame_of_a_file_allocates_nothing(SourceKind kind)
    {
        Performer performer = Play(kind);
        Time.captureFramerate = 60;
        Loop.Frames(20);
        FrameAllocations.AssertNone(Loop);
        Assert.True(performer.IsLive);
    }

    private static ValuesSource Walk() => new(static (frame, layout, values) => values[layout.GetPositionIndex(Bone.Hips)] = frame);

    // In centimetres. Unity's X axis is mirrored.
    private static float Travelled(Performer performer) => -100 * performer.GetPosition(Bone.Hips).x;

    private Performer Play(SourceKind kind, bool loop = true)
    {
        string file = Path.Combine(_folder, kind == SourceKind.BvhFile ? "take.bvh" : "take.nmrec");
        if (kind == SourceKind.BvhFile)
            WriteBvh(file);
        else
            WriteRecording(file);

        return WaitForPose(Add(source => (source.Kind, source.File, source.Loop) = (kind, file, loop)));
    }

    private static void WriteBvh(string file)
    {
        using var writer = new BvhTakeWriter(file, new BvhTakeOptions { FrameTime = BvhFrameTime.FromFrameRate(60) });
        foreach (MotionFrame frame in Frames())
            writer.Write(frame);
    }

    private static void WriteRecording(string file)
    {
        using RecordingWriter writer = RecordingWriter.Create(file);
        writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, "127.0.0.1:50000", "127.0.0.1:7001"));
        byte[] packet = new byte[64 + (Layout.ValueCount * sizeof(float))];
        foreach (MotionFrame frame in Frames())
        {
            PacketEncoder.WriteMotion(packet, frame.Header, frame.Values);
            writer.WriteBytes(TimeSpan.FromTicks(frame.Header.FrameIndex!.Value * TimeSpan.TicksPerSecond / 60), 0, packet);
        }
    }

    private static IEnumerable<MotionFrame> Frames()
    {
        ValuesSource actor = Walk();
        for (uint frame = 0; frame < 3000; frame++)
        {
            float[] values = new float[Layout.ValueCount];
            actor.WriteValues(frame, Layout, RotationOrder.YXZ, values);
            yield return new MotionFrame(new MotionHeader { FrameIndex = frame, HasDisplacement = true }, values);
        }
    }
}
