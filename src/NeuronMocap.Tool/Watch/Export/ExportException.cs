namespace NeuronMocap.Tool.Watch.Export;

/// <summary>The exception for a file that cannot be created. The message says why.</summary>
internal sealed class ExportException(string message, Exception innerException) : Exception(message, innerException);
