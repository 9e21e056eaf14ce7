namespace NeuronMocap.Tool.Output;

/// <summary>--quiet: the summary alone.</summary>
internal sealed class QuietOutput(Stream output) : WatchOutput
{
    // Its clock runs from here.
    private readonly JsonLines _lines = new();

    public override void Finish(ReaderStatistics statistics)
    {
        try
        {
            output.Write(_lines.Summary(statistics));
        }
        catch (IOException exception)
        {
            OnWriteFailed(exception);
        }
    }
}
