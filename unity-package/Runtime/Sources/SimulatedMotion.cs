#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>Specifies what the performers of the built-in simulator do.</summary>
    public enum SimulatedMotion
    {
        /// <summary>
        /// They walk in a circle of two metres, stop, wave, look around, count with their fingers and stretch. The motion repeats every 40 s.
        /// </summary>
        WalkAndGestures,

        /// <summary>They stand in the T-pose with arms to the sides. A figure that does not do the same is bound incorrectly.</summary>
        TPose,

        /// <summary>
        /// One joint after the other bends up, forward and about its length, while the others stay. It shows which bone of a figure follows which
        /// joint.
        /// </summary>
        JointByJoint,
    }
}
