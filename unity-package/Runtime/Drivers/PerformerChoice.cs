#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>Specifies how a figure finds its performer.</summary>
    public enum PerformerChoice
    {
        /// <summary>By its number on the server.</summary>
        ByIndex,

        /// <summary>By its name on the server.</summary>
        ByName,
    }
}
