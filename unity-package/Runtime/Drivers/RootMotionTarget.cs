#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>Specifies what the root motion of a figure moves.</summary>
    public enum RootMotionTarget
    {
        /// <summary>The hips. The figure walks away from its root transform, which stays in place.</summary>
        Hips,

        /// <summary>
        /// The root transform: it moves and turns with the performer, from where it stands. The hips stay above it.
        /// </summary>
        RootTransform,

        /// <summary>
        /// The <c>CharacterController</c> on the root transform or above it. It collides with the scene, falls and lands. The hips stay above it.
        /// </summary>
        CharacterController,
    }
}
