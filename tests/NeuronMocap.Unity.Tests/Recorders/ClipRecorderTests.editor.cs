using NeuronMocap.Unity.EditorTools;

namespace NeuronMocap.Unity.Tests.Recorders;

public sealed partial class ClipRecorderTests
{
    static partial void RegisterEditor() => ClipSaver.Register();
}
