#nullable enable

namespace NeuronMocap.Unity.EditorTools
{
    /// <summary>Specifies what a build check does when it finds a problem.</summary>
    public enum BuildProblem
    {
        /// <summary>Nothing.</summary>
        Ignore,

        /// <summary>Writes a warning to the console. The build continues.</summary>
        Warn,

        /// <summary>Fails the build with an error.</summary>
        Fail,
    }
}
