namespace NeuronMocap.Server.Faults;

// What the replies of a CommandServer do that they should not, or that nobody knows whether real servers do (protocol.md section 6).
// All of it is off unless set.
internal sealed class CommandReplyQuirks
{
    // Number of the command in every reply, 0 to 65535; null repeats that of the request. Default: null.
    public int? ReplyId { get; set; }

    // The field CommandType of every reply. Default: 0.
    public ushort CommandType { get; set; }

    // The field nReserved of every reply. Default: 0.
    public uint Reserved { get; set; }

    // The payload's size that every reply announces, whatever follows; null the right one. Default: null.
    public int? AnnouncedSize { get; set; }

    // Size that every payload is cut to, or filled up to with zeros, 0 to 1,048,576 bytes; null leaves it. Default: null.
    public int? PayloadSize { get; set; }

    // How often every request is answered, 0 to 16; 0 is a server that never answers. Default: 1.
    public int Answers { get; set; } = 1;

    // Whether a packet that nobody asked for, the answer to another command, comes before every reply. Default: false.
    public bool Unsolicited { get; set; }

    // Whether the connection is closed in place of every reply. Default: false.
    public bool CloseInstead { get; set; }

    // Bytes of the pieces that replies are written in, at least 1; null writes them whole. Default: null.
    public int? Fragment { get; set; }

    // How long to wait before every reply, up to 5 minutes. Default: not at all.
    public TimeSpan Delay { get; set; }

    internal CommandReplyQuirks Copy() => (CommandReplyQuirks)MemberwiseClone();
}
