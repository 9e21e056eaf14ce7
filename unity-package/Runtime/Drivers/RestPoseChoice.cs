#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>Specifies which pose of a generic rig corresponds to the performer's T-pose.</summary>
    public enum RestPoseChoice
    {
        /// <summary>The bind pose of the skin. Without a skin, the pose in the scene.</summary>
        BindPose,

        /// <summary>The pose in the scene when the component wakes up.</summary>
        AsItStands,

        /// <summary>The bind pose with arms, hands, fingers and legs straightened. Without a skin, the pose in the scene, straightened.</summary>
        TPose,
    }
}
