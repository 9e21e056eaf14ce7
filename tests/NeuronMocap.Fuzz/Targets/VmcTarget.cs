using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Protocol;
using NeuronMocap.Server.Osc;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>Receives the input as datagrams of VMC, whole and cut. Every packet that results is a motion packet with finite values.</summary>
internal static class VmcTarget
{
    private const int PacketSize = 1480;

    // Most datagrams hold bones without the end of their frame.
    private static ReadOnlySpan<byte> EndOfFrame => "/VMC/Ext/T\0\0,f\0\0\0\0\0\0"u8;

    public static void Run(FuzzInput input)
    {
        var decoder = new VmcDecoder(default);
        decoder.Receive(input.Bytes);
        decoder.Receive(EndOfFrame);
        Read(input, decoder);
        int cut = input.Random.Below(input.Bytes.Length + 1);
        decoder.Receive(input.Bytes[..cut]);
        decoder.Receive(input.Bytes[cut..]);
        decoder.Receive(EndOfFrame);
        Read(input, decoder);
        input.Digest.Add(decoder.Rejected);
    }

    private static void Read(FuzzInput input, VmcDecoder decoder)
    {
        WrongResultException.ThrowUnless(decoder.Length % PacketSize == 0, "{0} bytes are not whole packets.", decoder.Length);
        Span<byte> packet = stackalloc byte[PacketSize];
        while (decoder.Length > 0)
        {
            decoder.Read(packet);
            WrongResultException.ThrowUnless(MotionHeader.TryRead(packet, out MotionHeader header) && header.PacketSize == PacketSize, "The packet has another header.");
            foreach (float value in System.Runtime.InteropServices.MemoryMarshal.Cast<byte, float>(packet[ProtocolConstants.HeaderSize..]))
            {
                WrongResultException.ThrowUnless(float.IsFinite(value), "A value is {0}.", value);
                input.Digest.Add(value);
            }

            input.Found++;
        }
    }
}
