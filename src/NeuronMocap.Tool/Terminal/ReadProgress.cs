namespace NeuronMocap.Tool.Terminal;

/// <summary>Bytes read as a part of a file, and the end of the reading when somebody wants it.</summary>
/// <param name="length">Bytes of the file.</param>
/// <param name="progress">Receives the part, 0 to 1.</param>
/// <param name="cancelled">Ends the reading.</param>
internal sealed class ReadProgress(long length, IProgress<double> progress, CancellationToken cancelled) : IProgress<long>
{
    public void Report(long value)
    {
        cancelled.ThrowIfCancellationRequested();
        progress.Report((double)value / Math.Max(length, 1));
    }
}
