using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("NeuronMocap.Unity.Tests")]
[assembly: InternalsVisibleTo("NeuronMocap.Unity.Tests.EditMode")]
