using NeuronMocap.Server.Faults;

namespace NeuronMocap.Server;

/// <content>Rare or unconfirmed behaviour of real servers, for tests of readers. Not part of the public API.</content>
public sealed partial class BroadcasterOptions
{
    // Deviations of the text stream. Default: none.
    internal TextQuirks TextQuirks { get; set; }

    // Length field of replies to data commands. No known client reads it, and the value that real servers write is unknown.
    // Null writes 64 plus the number of bytes that follow. Default: null.
    internal int? DataCommandLength { get; set; }

    // Size of a piece in bytes, 1 to 1,048,576. Null leaves packets whole. Default: null. Over TCP the stream is written in pieces of exactly this
    // size, across packet boundaries. At a paced rate the last piece of the available data is shorter. A piece beyond 128 KB adds its length to the
    // data that a client must take within ClientTimeout. Over UDP a packet or a line of text is cut into datagrams of at most this size. Axis Neuron
    // on macOS uses 1024.
    internal int? Fragment { get; set; }
}
