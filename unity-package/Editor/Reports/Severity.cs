#nullable enable

namespace NeuronMocap.Unity.EditorTools
{
    // The severity of a row. The highest severity of several rows applies.
    internal enum Severity
    {
        None,
        Good,
        Waiting,
        Warning,
        Error,
    }
}
