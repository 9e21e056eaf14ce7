using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("NeuronMocap.Unity.Timeline.Editor")]
[assembly: InternalsVisibleTo("NeuronMocap.Unity.Tests")]
[assembly: InternalsVisibleTo("NeuronMocap.Unity.Tests.EditMode")]
