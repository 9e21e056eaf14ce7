namespace NeuronMocap.Tool.Watch.Export;

/// <summary>A file cannot be begun; the message says why.</summary>
internal sealed class ExportException(string message, Exception innerException) : Exception(message, innerException);
