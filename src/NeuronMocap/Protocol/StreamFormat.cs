namespace NeuronMocap;

/// <summary>The format that a server sends, detected from its frames.</summary>
public enum StreamFormat
{
    /// <summary>No frame has arrived yet.</summary>
    Unknown,

    /// <summary>
    /// Binary packets in the format of Axis Neuron: motion of data version 1.1.0.0, or calculation data (protocol.md sections 2.1 and 2.3).
    /// </summary>
    Binary,

    /// <summary>Binary packets of data version 1.0, which have no frame index (protocol.md section 2.2).</summary>
    OldHeader,

    /// <summary>Lines of text, which servers call the format "String" (protocol.md section 8).</summary>
    Text,

    /// <summary>Binary packets of Axis Studio: data version 1.1.0.1, or Axis Studio's own calculation packets (protocol.md section 9).</summary>
    Studio,
}
