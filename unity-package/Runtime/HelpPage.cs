#nullable enable

namespace NeuronMocap.Unity
{
    // The page that the question mark of an inspector opens.
    internal static class HelpPage
    {
        public const string Components = "https://github.com/neuronmocap/neuron-data-reader/blob/main/unity-package/Documentation~/components.md";
    }
}
