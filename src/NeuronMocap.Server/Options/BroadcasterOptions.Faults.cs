using NeuronMocap.Server.Faults;

namespace NeuronMocap.Server;

/// <content>What real servers do now and then, or nobody knows whether they do, for tests of readers. Not part of the public surface.</content>
public sealed partial class BroadcasterOptions
{
    // Peculiarities of the text. Default: none.
    internal TextQuirks TextQuirks { get; set; }

    // What stands in the length field of answers to commands of the old generation. No client is known to look at it, and nobody knows what real
    // servers write. Null: 64 and the bytes that follow. Default: null.
    internal int? DataCommandLength { get; set; }

    // Bytes of a piece, 1 to 1,048,576; null leaves packets whole. Over TCP the stream is written in pieces of exactly that many bytes across packet
    // boundaries; at a paced rate the last piece of what is there is shorter. Over UDP a packet, or a line of text, is cut into datagrams of at most
    // that many bytes: 1024 is what Axis Neuron on macOS does. A piece beyond 128 KB adds its length to what ClientTimeout allows. Default: null.
    internal int? Fragment { get; set; }
}
