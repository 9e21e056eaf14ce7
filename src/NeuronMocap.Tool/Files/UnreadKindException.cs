namespace NeuronMocap.Tool.Files;

/// <summary>The contents of a file are of no kind that the program reads.</summary>
internal sealed class UnreadKindException : NeuronException
{
    public UnreadKindException(string message)
        : base(message)
    {
    }

    public UnreadKindException(string message, Exception innerException)
        : base(message, innerException)
    {
    }

    /// <summary>Whether it is a GLB file, which can be a character.</summary>
    public bool IsGlb { get; init; }
}
