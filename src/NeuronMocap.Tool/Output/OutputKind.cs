namespace NeuronMocap.Tool.Output;

/// <summary>The formats of the output.</summary>
internal enum OutputKind
{
    /// <summary>The live view on a terminal; otherwise one plain line a second.</summary>
    Person,

    /// <summary>Every frame and every change of the state, one JSON object a line.</summary>
    Json,

    /// <summary>One JSON object at the end.</summary>
    Quiet,
}
