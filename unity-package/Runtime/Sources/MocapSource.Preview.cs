#nullable enable

namespace NeuronMocap.Unity
{
    // The source in edit mode, where Unity calls none of its methods.
    public sealed partial class MocapSource
    {
        internal void BeginPreview()
        {
            Enabled.Add(this);
            Open();
        }

        // In edit mode, instead of Update.
        internal void Preview() => Follow();

        internal void EndPreview() => OnDisable();
    }
}
