using System.Diagnostics.CodeAnalysis;

namespace NeuronMocap;

/// <content>On this target, logging would need a package; use <see cref="NeuronReader.EventReported"/> instead.</content>
public sealed partial class NeuronReaderOptions
{
    [SuppressMessage("Performance", "CA1822", Justification = "The member is that of the other target.")]
    internal Action<ReaderEvent>? CreateLog() => null;
}
