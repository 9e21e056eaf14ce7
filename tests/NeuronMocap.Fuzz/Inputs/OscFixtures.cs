using System.Buffers.Binary;
using NeuronMocap.Server.Osc;

namespace NeuronMocap.Fuzz.Inputs;

/// <summary>Datagrams of VMC, as this library and others send them.</summary>
internal static class OscFixtures
{
    /// <summary>Heads, sizes at limits, and numbers that are not finite.</summary>
    public static IReadOnlyList<byte[]> Words { get; } =
    [
        "#bundle\0"u8.ToArray(), "/VMC/Ext/T\0\0,f\0\0"u8.ToArray(), "/VMC/Ext/OK\0,i\0\0"u8.ToArray(), "Hips\0\0\0\0"u8.ToArray(), "UpperChest\0\0"u8.ToArray(),
        ",sfffffff\0\0\0"u8.ToArray(), [0, 0, 0, 0], [0, 0, 0, 4], [0, 0, 0, 0x10], [0x7F, 0xFF, 0xFF, 0xFF], [0x80, 0, 0, 0], [0xFF, 0xFF, 0xFF, 0xFF],
        [0x7F, 0x80, 0, 0], [0x7F, 0xC0, 0, 0], [0x7F, 0x7F, 0xFF, 0xFF], [0x3F, 0x80, 0, 0],
    ];

    public static IReadOnlyList<byte[]> Create()
    {
        List<byte[]> datagrams = [.. Frame(512), .. Frame(65_507)];
        byte[] nested = [.. "#bundle\0"u8, 0, 0, 0, 0, 0, 0, 0, 1, .. Size(datagrams[0].Length), .. datagrams[0], .. Size(datagrams[^1].Length), .. datagrams[^1]];
        return [.. datagrams, nested, "/VMC/Ext/T\0\0,f\0\0\0\0\0\0"u8.ToArray()];
    }

    private static List<byte[]> Frame(int maxSize)
    {
        List<byte[]> datagrams = [];
        var frame = new MotionFrame(new MotionHeader { HasDisplacement = true }, [.. Enumerable.Range(0, 354).Select(static index => (index * 37f % 360) - 180)]);
        var pose = new AvatarPose(sender: 0, index: 0);
        pose.Take(frame);
        new VmcEncoder(1, movesRoot: true, start: 0).TryEncode(pose, new OscBundle(maxSize, (bytes, length) => datagrams.Add(bytes[..length])));
        return datagrams;
    }

    private static byte[] Size(int length)
    {
        byte[] bytes = new byte[sizeof(int)];
        BinaryPrimitives.WriteInt32BigEndian(bytes, length);
        return bytes;
    }
}
