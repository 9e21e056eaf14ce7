using NeuronMocap.Delivery;

namespace NeuronMocap.Monitor.Output;

/// <summary>--quiet: the summary alone.</summary>
internal sealed class QuietOutput(Stream output) : MonitorOutput
{
    public override void Finish(ReaderStatistics statistics)
    {
        var lines = new JsonLines();
        try
        {
            output.Write(lines.Summary(statistics));
        }
        catch (IOException exception)
        {
            OnWriteFailed(exception);
        }
    }
}
