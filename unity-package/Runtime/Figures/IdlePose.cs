#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>Specifies what a spawned figure does while its performer's data has stopped.</summary>
    public enum IdlePose
    {
        /// <summary>It keeps the last pose.</summary>
        Hold,

        /// <summary>It stands in place, with arms down.</summary>
        Stand,

        /// <summary>It blends to its rest pose, usually a T-pose, or to the pose of its Animator.</summary>
        Rest,

        /// <summary>It is hidden.</summary>
        Hide,
    }
}
