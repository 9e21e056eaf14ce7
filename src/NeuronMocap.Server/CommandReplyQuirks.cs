namespace NeuronMocap.Server;

/// <summary>
/// What the replies of a <see cref="CommandServer"/> do that they should not, or that nobody knows whether real servers do (protocol.md section 6).
/// All of it is off unless set.
/// </summary>
public sealed class CommandReplyQuirks
{
    /// <summary>Number of the command in every reply, 0 to 65535; null repeats that of the request. Default: null.</summary>
    public int? ReplyId { get; set; }

    /// <summary>The field CommandType of every reply. Default: 0.</summary>
    public ushort CommandType { get; set; }

    /// <summary>The field nReserved of every reply. Default: 0.</summary>
    public uint Reserved { get; set; }

    /// <summary>The payload's size that every reply announces, whatever follows; null the right one. Default: null.</summary>
    public int? AnnouncedSize { get; set; }

    /// <summary>Size that every payload is cut to, or filled up to with zeros, 0 to 1,048,576 bytes; null leaves it. Default: null.</summary>
    public int? PayloadSize { get; set; }

    /// <summary>How often every request is answered, 0 to 16; 0 is a server that never answers. Default: 1.</summary>
    public int Answers { get; set; } = 1;

    /// <summary>Whether a packet that nobody asked for, the answer to another command, comes before every reply. Default: false.</summary>
    public bool Unsolicited { get; set; }

    /// <summary>Whether the connection is closed in place of every reply. Default: false.</summary>
    public bool CloseInstead { get; set; }

    /// <summary>Bytes of the pieces that replies are written in, at least 1; null writes them whole. Default: null.</summary>
    public int? Fragment { get; set; }

    /// <summary>How long to wait before every reply, up to 5 minutes. Default: not at all.</summary>
    public TimeSpan Delay { get; set; }

    internal CommandReplyQuirks Copy() => (CommandReplyQuirks)MemberwiseClone();
}
