#nullable enable

namespace NeuronMocap.Unity
{
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
