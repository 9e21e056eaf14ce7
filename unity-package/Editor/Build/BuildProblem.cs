#nullable enable

namespace NeuronMocap.Unity.EditorTools
{
    /// <summary>What a build check does where it finds something.</summary>
    public enum BuildProblem
    {
        /// <summary>Nothing.</summary>
        Ignore,

        /// <summary>Writes a warning to the console; the build goes on.</summary>
        Warn,

        /// <summary>Ends the build with an error.</summary>
        Fail,
    }
}
