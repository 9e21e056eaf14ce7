namespace NeuronMocap.Tests.Architecture.Samples.Other;

internal sealed class Unruled;
