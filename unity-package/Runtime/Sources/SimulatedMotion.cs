#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>What the performers of the built-in simulator do.</summary>
    public enum SimulatedMotion
    {
        /// <summary>They walk round a ring of two metres, stop, wave, look around, count with their fingers and stretch: again every 40 s.</summary>
        WalkAndGestures,

        /// <summary>They stand in the T-pose, arms out: a figure that does not do the same is bound wrongly.</summary>
        TPose,

        /// <summary>One joint after the other bends, up, forward and about its length, the rest stands: shows which bone of a figure follows which joint.</summary>
        JointByJoint,
    }
}
