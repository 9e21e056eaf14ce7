using System.Runtime.CompilerServices;

// The package itself must not see how tests control the stand-in.
[assembly: InternalsVisibleTo("NeuronMocap.Unity.Tests")]
