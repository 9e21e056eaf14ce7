namespace NeuronMocap.UnityPackager;

/// <summary>The exception for a package that cannot be created. The message says why.</summary>
internal sealed class PackagerException(string message) : Exception(message);
