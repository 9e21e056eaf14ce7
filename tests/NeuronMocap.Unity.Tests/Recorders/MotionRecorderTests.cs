using NeuronMocap.Bvh;
using NeuronMocap.Recording;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Recorders;

public sealed class MotionRecorderTests : IDisposable
{
    private readonly PlayerLoop _loop = new();
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("takes");

    public void Dispose()
    {
        _loop.Dispose();
        _folder.Delete(recursive: true);
    }

    [Fact]
    public void A_take_reads_back_with_all_its_frames()
    {
        MocapSource source = Stage.AddSimulator(performers: 2);
        MotionRecorder recorder = AddRecorder(source);
        recorder.Formats = TakeFormats.Bvh | TakeFormats.Recording;
        IReadOnlyList<string>? finished = null;
        recorder.Finished += files => finished = files;

        // The source is not open yet, so the take waits.
        Assert.True(recorder.StartRecording());
        _loop.RunUntil(() => recorder.Frames >= 60);
        Assert.Equal(RecorderState.Recording, recorder.State);
        Assert.True(recorder.Elapsed > 0.3);
        Assert.True(recorder.Bytes > 0);

        recorder.StopRecording();
        _loop.RunUntil(() => finished is not null);

        Assert.Equal(RecorderState.Idle, recorder.State);
        Assert.Empty(recorder.Problem);
        Assert.Equal(3, finished!.Count);
        long rows = 0;
        foreach (string file in finished.Where(static file => file.EndsWith(".bvh", StringComparison.Ordinal)))
        {
            BvhDocument take = BvhDocument.Load(file);
            Assert.Equal(59, take.Joints.Count);
            rows += take.FrameCount;
        }

        Assert.Equal(recorder.Frames, rows);
        Assert.Equal(finished.Sum(static file => new FileInfo(file).Length), recorder.Bytes);
        using RecordingReader recording = RecordingReader.Open(finished.Single(static file => file.EndsWith(".nmrec", StringComparison.Ordinal)));
        Assert.True(recording.IsComplete);
        Assert.True(recording.Duration.TotalSeconds > 0.3);
        Assert.Empty(recording.Problems);
    }

    [Fact]
    public void Takes_have_a_name_and_a_slate_that_counts_up()
    {
        MocapSource source = Stage.AddSimulator();
        MotionRecorder recorder = AddRecorder(source);
        (recorder.TakeName, recorder.Slate, recorder.FileName) = ("Shot", 7, "{name} {take}");
        foreach (int slate in (int[])[7, 8])
        {
            Assert.Equal(slate, recorder.Slate);
            Assert.True(recorder.StartRecording());
            _loop.RunUntil(() => recorder.Frames >= 10);
            Assert.Equal(slate, recorder.Slate);
            Assert.True(recorder.Elapsed > 0);
            recorder.StopRecording();
            _loop.RunUntil(() => recorder.State == RecorderState.Idle);
            Assert.StartsWith($"Shot 00{slate}", Path.GetFileName(Assert.Single(recorder.Files)), StringComparison.Ordinal);
        }

        // A take without files has no number.
        recorder.Folder = recorder.Files[0];
        Assert.True(recorder.StartRecording());
        _loop.RunUntil(() => recorder.State == RecorderState.Idle);
        Assert.Contains("cannot start", recorder.Problem);
        Assert.Equal(9, recorder.Slate);

        // The slate begins again, as after play mode, and the files are still there.
        (recorder.Folder, recorder.Slate) = (_folder.FullName, 1);
        Assert.True(recorder.StartRecording());
        _loop.RunUntil(() => recorder.Frames >= 10);
        recorder.StopRecording();
        _loop.RunUntil(() => recorder.State == RecorderState.Idle);
        Assert.Equal(2, recorder.Slate);
    }

    [Fact]
    public void Disabling_completes_the_take()
    {
        MocapSource source = Stage.AddSimulator();
        MotionRecorder recorder = AddRecorder(source);
        recorder.AllPerformers = false;
        recorder.RecordOnPlay = true;
        IReadOnlyList<string>? finished = null;
        recorder.Finished += files => finished = files;
        _loop.RunUntil(() => recorder.Frames >= 10);

        recorder.enabled = false;
        Assert.Equal(RecorderState.Finishing, recorder.State);
        _loop.Frames(5);
        Assert.Null(finished);
        recorder.enabled = true;
        _loop.RunUntil(() => recorder.State == RecorderState.Idle);
        Assert.Equal(recorder.Files, finished);

        Assert.Equal(recorder.Frames, BvhDocument.Load(Assert.Single(recorder.Files)).FrameCount);
    }

    [Fact]
    public void Leaving_play_mode_completes_the_take()
    {
        MocapSource source = Stage.AddSimulator();
        MotionRecorder recorder = AddRecorder(source);
        recorder.RecordOnPlay = true;
        _loop.RunUntil(() => recorder.Frames >= 10);
        long frames = recorder.Frames;

        _loop.ExitPlayMode();

        string file = Directory.GetFiles(_folder.FullName).Single();

        // The game waits only a moment for the disk.
        Assert.True(SpinWait.SpinUntil(() => BvhDocument.Load(file).FrameCount >= frames, Limits.Unexpected));
    }

    [Fact]
    public void The_end_of_the_source_completes_the_take()
    {
        MocapSource source = Stage.AddSimulator();
        MotionRecorder recorder = AddRecorder(source);
        recorder.RecordOnPlay = true;
        _loop.RunUntil(() => recorder.Frames >= 10);

        source.enabled = false;
        _loop.RunUntil(() => recorder.State == RecorderState.Idle);

        Assert.Equal(recorder.Frames, BvhDocument.Load(Assert.Single(recorder.Files)).FrameCount);
    }

    [Fact]
    public void A_handler_that_throws_keeps_the_files_from_no_other()
    {
        MotionRecorder recorder = AddRecorder(Stage.AddSimulator());
        recorder.Finished += static _ => throw new InvalidOperationException("finished");
        IReadOnlyList<string>? finished = null;
        recorder.Finished += files => finished = files;
        recorder.RecordOnPlay = true;
        _loop.RunUntil(() => recorder.Frames >= 10);
        recorder.StopRecording();
        _loop.RunUntil(() => recorder.State == RecorderState.Idle);

        Assert.Single(finished!);
        Assert.Equal("finished", Assert.Single(ConsoleLog.Entries).Exception!.Message);
    }

    [Fact]
    public void Invalid_settings_are_reported()
    {
        MotionRecorder recorder = AddRecorder(null);
        Assert.False(recorder.StartRecording());
        Assert.Contains("Source", recorder.Problem);

        MocapSource source = Stage.AddSimulator();
        recorder.Source = source;
        recorder.Formats = TakeFormats.None;
        Assert.False(recorder.StartRecording());
        Assert.Contains("Formats", recorder.Problem);

        recorder.Formats = TakeFormats.Bvh;
        recorder.enabled = false;
        Assert.False(recorder.StartRecording());
        Assert.Contains("disabled", recorder.Problem);

        // A file is in the place of the folder.
        recorder.enabled = true;
        string taken = Path.Combine(_folder.FullName, "taken");
        File.WriteAllText(taken, "");
        recorder.Folder = Path.Combine(taken, "below");
        Assert.True(recorder.StartRecording());
        Assert.False(recorder.StartRecording());
        Assert.Contains("already", recorder.Problem);
        _loop.RunUntil(() => recorder.State == RecorderState.Idle);
        Assert.Contains("cannot start", recorder.Problem);
    }

    [Fact]
    public void A_source_that_is_removed_before_it_is_open_is_reported()
    {
        MocapSource source = Stage.AddSimulator();
        MotionRecorder recorder = AddRecorder(source);
        Assert.True(recorder.StartRecording());
        Assert.Equal(RecorderState.Waiting, recorder.State);

        Object.DestroyImmediate(source.gameObject);
        _loop.Frame();

        Assert.Equal(RecorderState.Idle, recorder.State);
        Assert.Contains("source was removed", recorder.Problem);
    }

    [Fact]
    public void A_frame_allocates_nothing()
    {
        MocapSource source = Stage.AddSimulator();
        MotionRecorder recorder = AddRecorder(source);
        recorder.Formats = TakeFormats.Bvh | TakeFormats.Recording;
        recorder.RecordOnPlay = true;
        _loop.RunUntil(() => recorder.Frames >= 10);

        Assert.Equal(0, Measure.BytesPerFrame(_loop, recorder, "Update"));
        Assert.Equal(RecorderState.Recording, recorder.State);
    }

    private MotionRecorder AddRecorder(MocapSource? source)
    {
        var recorder = new GameObject("Recorder").AddComponent<MotionRecorder>();
        recorder.Source = source;
        recorder.Folder = _folder.FullName;
        return recorder;
    }
}
