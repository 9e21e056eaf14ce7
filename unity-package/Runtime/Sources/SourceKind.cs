#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>Where the motion of a <see cref="MocapSource"/> comes from.</summary>
    public enum SourceKind
    {
        /// <summary>Axis Neuron or Axis Studio, over TCP or UDP.</summary>
        Network,

        /// <summary>Performers that the package makes up itself: nothing else is needed.</summary>
        Simulator,

        /// <summary>A BVH file that Axis Neuron exported, or one of the same skeleton.</summary>
        BvhFile,

        /// <summary>A recording of a stream (<c>.nmrec</c>), or a raw dump of its bytes.</summary>
        Recording,
    }
}
