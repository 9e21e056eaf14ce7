using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("NeuronMocap.Unity.Tests")]
