#nullable enable

namespace NeuronMocap.Unity.EditorTools
{
    // What takes the place of a vendor's component.
    internal enum VendorKind
    {
        Humanoid,
        Generic,
        None,
    }
}
