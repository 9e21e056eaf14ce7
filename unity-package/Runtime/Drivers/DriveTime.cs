#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>When a figure is moved.</summary>
    public enum DriveTime
    {
        /// <summary>After the Animator: the motion wins over animations.</summary>
        LateUpdate,

        /// <summary>Before the Animator, which writes over what it animates itself.</summary>
        Update,
    }
}
