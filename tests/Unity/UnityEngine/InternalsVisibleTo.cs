using System.Runtime.CompilerServices;

// The package itself must not see how tests control the stand-in.
[assembly: InternalsVisibleTo("UnityEditor")]
[assembly: InternalsVisibleTo("UnityEngine.TestRunner")]
[assembly: InternalsVisibleTo("Unity.Timeline")]
[assembly: InternalsVisibleTo("Unity.LiveCapture")]
[assembly: InternalsVisibleTo("NeuronMocap.Unity.Tests")]
[assembly: InternalsVisibleTo("NeuronMocap.Benchmarks")]
[assembly: InternalsVisibleTo("program")]
