#nullable enable

namespace NeuronMocap.Unity.EditorTools
{
    // How much a line matters. The highest of several decides.
    internal enum Severity
    {
        None,
        Good,
        Waiting,
        Warning,
        Error,
    }
}
