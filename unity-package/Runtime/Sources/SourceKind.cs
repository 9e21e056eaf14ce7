#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>Specifies where the motion of a <see cref="MocapSource"/> comes from.</summary>
    public enum SourceKind
    {
        /// <summary>Axis Neuron or Axis Studio, over TCP or UDP.</summary>
        Network,

        /// <summary>Performers simulated by the package. Nothing else is needed.</summary>
        Simulator,

        /// <summary>A BVH file exported by Axis Neuron, or another file with the same skeleton.</summary>
        BvhFile,

        /// <summary>A recording of a stream (<c>.nmrec</c>), or a raw dump of its bytes.</summary>
        Recording,
    }
}
