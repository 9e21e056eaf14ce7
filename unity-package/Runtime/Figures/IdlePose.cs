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

    /// <summary>Where a spawner puts its figures.</summary>
    public enum FigurePlacement
    {
        /// <summary>All at the spawner: the performers share one stage, and stand on it as they did on theirs.</summary>
        SharedStage,

        /// <summary>Each on a stage of its own, side by side, the first in the middle.</summary>
        Row,

        /// <summary>Each on a stage of its own, in rows one behind the other.</summary>
        Grid,
    }
}
