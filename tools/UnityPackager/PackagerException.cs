namespace NeuronMocap.UnityPackager;

/// <summary>The package cannot be made, and why.</summary>
internal sealed class PackagerException(string message) : Exception(message);
