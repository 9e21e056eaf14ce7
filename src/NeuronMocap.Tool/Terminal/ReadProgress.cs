namespace NeuronMocap.Tool.Terminal;

/// <summary>Turns the bytes read so far into a part of the file, and ends the reading when it is cancelled.</summary>
/// <param name="length">Bytes of the file.</param>
/// <param name="progress">Receives the part, 0 to 1.</param>
/// <param name="cancellationToken">Ends the reading.</param>
internal sealed class ReadProgress(long length, IProgress<double> progress, CancellationToken cancellationToken) : IProgress<long>
{
    public void Report(long value)
    {
        cancellationToken.ThrowIfCancellationRequested();
        progress.Report((double)value / Math.Max(length, 1));
    }
}
