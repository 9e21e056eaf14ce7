using NeuronMocap.Recording;

namespace NeuronMocap.Tool.Watch.Recordings;

/// <summary>One recording of a run, and the frames that arrived while it ran.</summary>
/// <param name="recorder">Writes the file.</param>
/// <param name="framesBefore">Frames that had arrived when it began.</param>
internal sealed class Take(StreamRecorder recorder, long framesBefore)
{
    private long? _framesAtEnd;

    public StreamRecorder Recorder => recorder;

    /// <summary>Whether it still records. False once it was stopped or has failed.</summary>
    public bool IsRecording => _framesAtEnd is null && recorder.Failure is null;

    /// <summary>Frames that the recording has seen.</summary>
    /// <param name="arrived">Frames that have arrived in the whole run.</param>
    public long CountFrames(long arrived) => (_framesAtEnd ?? arrived) - framesBefore;

    /// <summary>Begins to end the recording, without waiting for the disk.</summary>
    /// <param name="arrived">Frames that have arrived in the whole run.</param>
    /// <returns>Completes when the file is closed.</returns>
    public Task StopAsync(long arrived)
    {
        Task closed = recorder.StopAsync(CancellationToken.None);
        _framesAtEnd ??= arrived;
        return closed;
    }
}
