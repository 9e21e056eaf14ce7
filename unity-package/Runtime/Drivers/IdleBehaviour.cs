#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>Specifies what a figure does when its performer sends nothing.</summary>
    public enum IdleBehaviour
    {
        /// <summary>It keeps the last pose.</summary>
        Hold,

        /// <summary>It blends to its rest pose, or to the pose of an Animator, within the blend time.</summary>
        BlendToRest,
    }
}
