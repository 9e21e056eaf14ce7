using NeuronMocap.Recording;

namespace NeuronMocap.Tool.Watch.Recordings;

/// <summary>One recording of a run, and the number of frames that arrived during it.</summary>
/// <param name="recorder">Writes the file.</param>
/// <param name="framesBefore">Number of frames that had arrived at its start.</param>
internal sealed class Take(StreamRecorder recorder, long framesBefore)
{
    private long _framesAtEnd;
    private volatile bool _isStopped;

    public StreamRecorder Recorder => recorder;

    /// <summary>Whether it is still recording. False after it was stopped or has failed. Any thread.</summary>
    public bool IsRecording => !_isStopped && recorder.Failure is null;

    /// <summary>Gets the number of frames that arrived during the recording.</summary>
    /// <param name="arrived">Frames that have arrived in the whole run.</param>
    public long CountFrames(long arrived) => (_isStopped ? _framesAtEnd : arrived) - framesBefore;

    /// <summary>Requests the end of the recording, without waiting for the disk.</summary>
    /// <param name="arrived">Frames that have arrived in the whole run.</param>
    /// <returns>A task that completes when the file is closed.</returns>
    public Task StopAsync(long arrived)
    {
        Task closed = recorder.StopAsync(CancellationToken.None);
        if (!_isStopped)
            (_framesAtEnd, _isStopped) = (arrived, true);

        return closed;
    }
}
