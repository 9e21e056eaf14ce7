using System.Diagnostics.CodeAnalysis;
using NeuronMocap.Delivery;

namespace NeuronMocap.Telemetry;

// There are no meters without a package on this target: its readers are asked for their statistics.
[SuppressMessage("Performance", "CA1822", Justification = "The members are those of the other target.")]
internal sealed class ReaderMetrics(string name) : IDisposable
{
    public string Name => name;

    public IDurationRecorder? Intervals => null;

    public IDurationRecorder? HandOver(string consumer) => null;

    public void Observe(IReaderStatistics figures)
    {
    }

    public void Dispose()
    {
    }
}
