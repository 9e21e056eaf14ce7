namespace NeuronMocap.Fuzz.Inputs;

/// <summary>Specifies the kind of a target's inputs.</summary>
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

    /// <summary>Compact poses.</summary>
    Poses,

    /// <summary>Files of every kind that the file tools read.</summary>
    Files,
}
