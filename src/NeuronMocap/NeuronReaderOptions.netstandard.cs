using System.Diagnostics.CodeAnalysis;

namespace NeuronMocap;

/// <content>Logging would need a package on this target; see <see cref="NeuronReader.EventReported"/>.</content>
public sealed partial class NeuronReaderOptions
{
    [SuppressMessage("Performance", "CA1822", Justification = "The member is that of the other target.")]
    internal Action<ReaderEvent>? CreateLog() => null;
}
