#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>What a figure does when its performer sends nothing.</summary>
    public enum IdleBehaviour
    {
        /// <summary>Keeps the last pose.</summary>
        Hold,

        /// <summary>Goes over to its rest pose, or to what an Animator plays, within the blend time.</summary>
        BlendToRest,
    }
}
