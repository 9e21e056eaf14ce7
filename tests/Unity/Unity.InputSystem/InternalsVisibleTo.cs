using System.Runtime.CompilerServices;

// The package itself must not see how tests press keys.
[assembly: InternalsVisibleTo("NeuronMocap.Unity.Tests")]
