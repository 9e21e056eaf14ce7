using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("NeuronMocap.Unity.Editor")]
[assembly: InternalsVisibleTo("NeuronMocap.Unity.Compatibility")]
[assembly: InternalsVisibleTo("NeuronMocap.Unity.InputSystem")]
[assembly: InternalsVisibleTo("NeuronMocap.Unity.Timeline")]
[assembly: InternalsVisibleTo("NeuronMocap.Unity.Timeline.Editor")]
[assembly: InternalsVisibleTo("NeuronMocap.Unity.LiveCapture")]
[assembly: InternalsVisibleTo("NeuronMocap.Unity.Tests")]
[assembly: InternalsVisibleTo("NeuronMocap.Unity.Tests.EditMode")]
[assembly: InternalsVisibleTo("NeuronMocap.Unity.Tests.PlayMode")]
