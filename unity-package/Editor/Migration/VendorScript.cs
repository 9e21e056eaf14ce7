#nullable enable

namespace NeuronMocap.Unity.EditorTools
{
    // A script of the vendor's Unity integration.
    internal sealed class VendorScript
    {
        public VendorScript(string name, VendorKind kind, string reason = "", bool isMissing = false)
        {
            Name = name;
            Kind = kind;
            Reason = reason;
            IsMissing = isMissing;
        }

        public string Name { get; }

        public VendorKind Kind { get; }

        // Why it cannot be converted. Empty if it can.
        public string Reason { get; }

        // Whether the project has no class for it.
        public bool IsMissing { get; }
    }
}
