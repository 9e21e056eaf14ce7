#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>What a spawned figure does while its performer's data has stopped.</summary>
    public enum IdlePose
    {
        /// <summary>Stays as it is.</summary>
        Hold,

        /// <summary>Stands where it is, arms down.</summary>
        Stand,

        /// <summary>Goes to its rest pose, a T-pose in most cases, or to what its Animator plays.</summary>
        Rest,

        /// <summary>Is not there.</summary>
        Hide,
    }
}
