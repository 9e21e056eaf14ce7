namespace NeuronMocap.Server.Faults;

// Deviations of a CommandServer's replies from the protocol, for tests. Some are wrong; for others the behaviour of real servers is unknown
// (protocol.md section 6). All are off by default.
internal sealed class CommandReplyQuirks
{
    // Command number in every reply, 0 to 65535. Null repeats the number of the request. Default: null.
    public int? ReplyId { get; set; }

    // The field CommandType of every reply. Default: 0.
    public ushort CommandType { get; set; }

    // The field nReserved of every reply. Default: 0.
    public uint Reserved { get; set; }

    // Payload size that every reply announces, whatever follows. Null announces the correct size. Default: null.
    public int? AnnouncedSize { get; set; }

    // Size that every payload is cut or zero-filled to, 0 to 1,048,576 bytes. Null leaves payloads unchanged. Default: null.
    public int? PayloadSize { get; set; }

    // How often every request is answered, 0 to 16. With 0 the server never answers. Default: 1.
    public int Answers { get; set; } = 1;

    // Whether an unrequested packet, the answer to another command, precedes every reply. Default: false.
    public bool Unsolicited { get; set; }

    // Whether the connection is closed instead of every reply. Default: false.
    public bool CloseInstead { get; set; }

    // Size in bytes of the pieces that replies are written in, at least 1. Null writes replies whole. Default: null.
    public int? Fragment { get; set; }

    // Delay before every reply, up to 5 minutes. Default: none.
    public TimeSpan Delay { get; set; }

    internal CommandReplyQuirks Copy() => (CommandReplyQuirks)MemberwiseClone();
}
