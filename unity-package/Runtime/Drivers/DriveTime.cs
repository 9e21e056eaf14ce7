#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>Specifies when a figure is moved.</summary>
    public enum DriveTime
    {
        /// <summary>After the Animator. The motion replaces animations.</summary>
        LateUpdate,

        /// <summary>Before the Animator. Animations replace the motion of the bones that they animate.</summary>
        Update,

        /// <summary>
        /// In each physics step. Bones with a kinematic Rigidbody move through physics, so that they push other bodies with the right speed.
        /// </summary>
        Physics,
    }
}
