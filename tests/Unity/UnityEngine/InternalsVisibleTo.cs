using System.Runtime.CompilerServices;

// The package itself must not see how the stand-in is driven.
[assembly: InternalsVisibleTo("UnityEditor")]
[assembly: InternalsVisibleTo("UnityEngine.TestRunner")]
[assembly: InternalsVisibleTo("NeuronMocap.Unity.Tests")]
[assembly: InternalsVisibleTo("program")]
