#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>Specifies where a spawner puts its figures.</summary>
    public enum FigurePlacement
    {
        /// <summary>All figures are at the spawner. The performers share one stage and stand on it as they did on theirs.</summary>
        SharedStage,

        /// <summary>Each figure has its own stage, side by side, the first in the middle.</summary>
        Row,

        /// <summary>Each figure has its own stage, in rows one behind the other.</summary>
        Grid,
    }
}
