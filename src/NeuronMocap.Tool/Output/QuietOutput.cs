namespace NeuronMocap.Tool.Output;

/// <summary>--quiet: writes only the summary.</summary>
internal sealed class QuietOutput(Stream output) : WatchOutput
{
    // Its clock starts here.
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
