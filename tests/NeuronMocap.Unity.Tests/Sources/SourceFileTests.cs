using NeuronMocap.Bvh;
using NeuronMocap.Recording;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Sources;

public sealed class SourceFileTests : SourceFixture
{
    private static readonly ChannelLayout Layout = new(hasDisplacement: true, hasReference: false);

    private readonly string _folder = Directory.CreateTempSubdirectory("neuron-unity").FullName;

    public override void Dispose()
    {
        base.Dispose();
        Directory.Delete(_folder, recursive: true);
        GC.SuppressFinalize(this);
    }

    [Fact]
    public void A_BVH_file_plays_again_and_again()
    {
        string file = WriteTake();
        MocapSource source = AddFile(SourceKind.BvhFile, file, loop: true);
        Assert.Equal(SourceState.Closed, source.State);
        Performer performer = WaitForPose(source);
        Assert.Equal("take", performer.Name);
        Assert.Contains("ile take", source.StatusMessage, StringComparison.Ordinal);

        // Half a second long.
        Loop.RunFor(1);
        Assert.Equal(SourceState.Receiving, source.State);
    }

    [Fact]
    public void The_end_of_a_BVH_file_is_reported()
    {
        MocapSource source = AddFile(SourceKind.BvhFile, WriteTake(), loop: false);
        WaitForPose(source);
        Loop.RunUntil(() => source.State == SourceState.Ended);
        Assert.Equal("The file take has ended. Switch Loop on to repeat it.", source.StatusMessage);
    }

    [Fact]
    public void A_text_asset_plays_like_a_file()
    {
        string text = File.ReadAllText(WriteTake());
        MocapSource source = Add(source =>
        {
            source.Kind = SourceKind.BvhFile;
            source.BvhAsset = new TextAsset(text) { name = "walk" };
        });
        Assert.Equal("walk", WaitForPose(source).Name);
    }

    [Fact]
    public void A_recording_plays_faster_and_ends()
    {
        MocapSource source = AddFile(SourceKind.Recording, WriteRecording(), loop: false);
        source.Speed = 2;
        Performer performer = WaitForPose(source);
        Assert.Equal("Char00", performer.Name);
        Assert.NotNull(source.Player);
        Loop.RunUntil(() => source.State == SourceState.Ended);
        Assert.Contains("Loop", source.StatusMessage, StringComparison.Ordinal);
    }

    [Fact]
    public void A_recording_plays_again_and_again()
    {
        MocapSource source = AddFile(SourceKind.Recording, WriteRecording(), loop: true);
        WaitForPose(source);
        Loop.RunUntil(() => source.Player!.Pass > 2);
        Loop.RunUntil(() => source.State == SourceState.Receiving);
    }

    [Theory]
    [InlineData(SourceKind.BvhFile, "", "File is empty")]
    [InlineData(SourceKind.Recording, "", "File is empty")]
    [InlineData(SourceKind.BvhFile, "nothing.bvh", "cannot be played")]
    [InlineData(SourceKind.Recording, "nothing.nmrec", "cannot be played")]
    [InlineData(SourceKind.BvhFile, "jar:file://app.apk!/assets/walk.bvh", "text asset")]
    public void A_damaged_file_is_explained(SourceKind kind, string file, string expected)
    {
        MocapSource source = AddFile(kind, file, loop: true);
        Loop.RunUntil(() => source.State == SourceState.Failed);
        Assert.Contains(expected, source.StatusMessage, StringComparison.Ordinal);
    }

    [Fact]
    public void An_invalid_take_is_explained()
    {
        string file = Path.Combine(_folder, "note.bvh");
        File.WriteAllText(file, "Not a hierarchy.");
        MocapSource source = AddFile(SourceKind.BvhFile, file, loop: true);
        Loop.RunUntil(() => source.State == SourceState.Failed);
        Assert.Contains("file note cannot be played", source.StatusMessage, StringComparison.Ordinal);
    }

    [Fact]
    public void Closing_while_reading_a_file_leaves_nothing()
    {
        string file = WriteTake();
        double quickest = double.PositiveInfinity;
        for (int i = 0; i < 20; i++)
        {
            MocapSource source = AddFile(SourceKind.BvhFile, file, loop: true);
            Loop.Frame();
            quickest = Math.Min(quickest, Measure(() => source.enabled = false));
        }

        Assert.InRange(quickest, 0, Quick);
        Assert.Equal(0, SourceConnections.Count);
    }

    private static MocapSource AddFile(SourceKind kind, string file, bool loop) =>
        Add(source => (source.Kind, source.File, source.Loop) = (kind, file, loop));

    private string WriteTake()
    {
        string file = Path.Combine(_folder, "take.bvh");
        var actor = new SyntheticSource(60);
        using var writer = new BvhTakeWriter(file, new BvhTakeOptions { FrameTime = BvhFrameTime.FromFrameRate(60) });
        float[] values = new float[Layout.ValueCount];
        for (uint frame = 0; frame < 30; frame++)
        {
            actor.WriteValues(frame, Layout, RotationOrder.YXZ, values);
            writer.Write(new MotionFrame(new MotionHeader { FrameIndex = frame, HasDisplacement = true }, values));
        }

        return file;
    }

    private string WriteRecording()
    {
        string file = Path.Combine(_folder, "take.nmrec");
        Broadcaster server = Serve(new SyntheticSource(100));
        using var reader = new NeuronReader("127.0.0.1", server.LocalEndPoint!.Port);
        int frames = 0;
        reader.MotionReceived += _ => Interlocked.Increment(ref frames);
        using StreamRecorder recorder = reader.StartRecording(file);
        reader.Start();
        Assert.True(SpinWait.SpinUntil(() => Volatile.Read(ref frames) > 30, Limits.Unexpected));
        return file;
    }
}
