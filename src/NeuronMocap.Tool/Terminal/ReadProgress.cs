namespace NeuronMocap.Tool.Terminal;

/// <summary>Converts the number of read bytes to progress, and ends the reading when it is cancelled.</summary>
/// <param name="length">Size of the file in bytes.</param>
/// <param name="progress">Receives progress, 0 to 1.</param>
/// <param name="cancellationToken">Cancels the reading.</param>
internal sealed class ReadProgress(long length, IProgress<double> progress, CancellationToken cancellationToken) : IProgress<long>
{
    public void Report(long value)
    {
        cancellationToken.ThrowIfCancellationRequested();
        progress.Report((double)value / Math.Max(length, 1));
    }
}
