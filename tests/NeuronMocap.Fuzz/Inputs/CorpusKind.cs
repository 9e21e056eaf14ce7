namespace NeuronMocap.Fuzz.Inputs;

/// <summary>What the inputs of a target are made of.</summary>
internal enum CorpusKind
{
    /// <summary>Packets of the stream.</summary>
    Packets,

    /// <summary>Replies of a command server.</summary>
    Commands,

    /// <summary>Lines of the text stream.</summary>
    Text,

    /// <summary>BVH text.</summary>
    Bvh,

    /// <summary>Recordings.</summary>
    Recordings,

    /// <summary>Rows of a calculation export.</summary>
    Calculation,

    /// <summary>Files of every kind that the tools for files read.</summary>
    Files,
}
