using System.Diagnostics.CodeAnalysis;
using NeuronMocap.Delivery;

namespace NeuronMocap.Telemetry;

// Meters would need a package on this target framework. Use a reader's statistics instead.
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
