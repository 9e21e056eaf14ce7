using System.Numerics;
using NeuronMocap.Server.Osc;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Tests.Osc;

public sealed class VmcDecoderTests
{
    private readonly VmcDecoder _decoder = new(new AvatarName("Ann"));

    [Theory]
    [InlineData(180, SkeletonVariant.Neck1, false)]
    [InlineData(360, SkeletonVariant.Neck1, true)]
    [InlineData(354, SkeletonVariant.Spine3, true)]
    public void What_a_sender_sends_comes_back(int count, SkeletonVariant variant, bool movesRoot)
    {
        var encoder = new VmcEncoder(1, movesRoot, 0);
        for (int seed = 0; seed < 20; seed++)
        {
            MotionFrame sent = Poses.Frame(seed, count: count, variant: variant);
            foreach (byte[] datagram in Poses.Encode(encoder, Poses.Taken(sent)))
                _decoder.Receive(datagram);

            MotionFrame received = Assert.Single(Frames());
            Assert.Equal(("Ann", (uint)seed), (received.AvatarName, received.FrameIndex));

            // VMC has 50 of the bones. The received frame has the usual naming, in which the shoulders hang from bone 9.
            BoneTransform[] expected = Poses.World(sent);
            BoneTransform[] actual = Poses.World(received);
            foreach ((string bone, _, Bone source) in VmcModel.Bones)
            {
                int index = variant == SkeletonVariant.Spine3 && bone == "UpperChest" ? (int)Bone.Neck : (int)source;
                Poses.AssertSame(expected[index], actual[(int)source], 0.05f, bone);
            }
        }

        Assert.Equal(0, _decoder.Rejected);
    }

    [Fact]
    public void A_frame_ends_wherever_the_sender_says_so()
    {
        // At the end, at the start, both, with more arguments, single messages, and never.
        Receive(Place("Hips"), Place("Head"), Message("/VMC/Ext/OK", "i", 1), Message("/VMC/Ext/T", "f", 1f));
        Assert.Single(Frames());
        Receive(Message("/VMC/Ext/T", "f", 2f), Message("/VMC/Ext/OK", "iii", 1, 3, 0), Place("Hips"), Place("Head"));
        Assert.Empty(Frames());
        Receive(Message("/VMC/Ext/T", "f", 3f), Place("Hips"), Message("/VMC/Ext/OK", "i", 1));
        Assert.Equal(2, Frames().Count);
        _decoder.Receive(Place("Hips"));
        _decoder.Receive(Place("Head"));
        Assert.Empty(Frames());
        _decoder.Receive(Place("Hips"));
        Assert.Single(Frames());
        Assert.Equal(0, _decoder.Rejected);
    }

    [Fact]
    public void A_model_with_few_bones_and_without_positions_has_the_default_lengths()
    {
        Receive(
            Message("/VMC/Ext/Root/Pos", "sfffffffffffff", "root", 1f, 0f, 0f, 0f, 0f, 0f, 1f, 1f, 1f, 1f, 0f, 0f, 0f),
            Place("Hips", 0, 1, 0),
            Place("LeftLowerLeg"),
            Place("LeftEye"),
            Place("Tail"),
            Message("/VMC/Ext/Blend/Val", "sf", "Joy", 1f),
            Message("/VMC/Ext/T", "f", 1f));
        MotionFrame frame = Assert.Single(Frames());
        Assert.Equal(new Vector3(-100, 100, 0), frame.GetPosition(Bone.Hips));
        foreach (Bone bone in BoneHierarchy.Bones[1..])
        {
            Assert.Equal(DefaultOffsets.Get(bone), frame.GetPosition(bone));
            Assert.Equal(Vector3.Zero, frame.GetEulerAngles(bone));
        }
    }

    [Fact]
    public void A_bone_that_the_model_lacks_has_no_length()
    {
        // The upper arm is placed relative to the spine, because there is neither chest nor shoulder.
        Receive(Place("Hips", 0, 1, 0), Place("Spine", 0, 0.1f, 0), Place("LeftUpperArm", -0.2f, 0.3f, 0), Place("Head", 0, 0.5f, 0), Message("/VMC/Ext/OK", "i", 1));
        BoneTransform[] world = Poses.World(Assert.Single(Frames()));
        Assert.True(Vector3.Distance(new Vector3(20, 140, 0), world[(int)Bone.LeftArm].Position) < 1e-3f);
        Assert.True(Vector3.Distance(new Vector3(0, 160, 0), world[(int)Bone.Head].Position) < 1e-3f);
    }

    [Fact]
    public void Other_bytes_are_counted_and_ignored()
    {
        byte[][] bad =
        [
            [], [1, 2, 3], "#bundle\0"u8.ToArray(), [.. "#bundle\0"u8, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0], [.. "#bundle\0"u8, 0, 0, 0, 0, 0, 0, 0, 1, 0x7F, 0xFF, 0xFF, 0xFF],
            [.. "#bundle\0"u8, 0, 0, 0, 0, 0, 0, 0, 1, 0xFF, 0xFF, 0xFF, 0xFF], "/VMC/Ext/T"u8.ToArray(), "/VMC/Ext/T\0\0"u8.ToArray(), "/VMC/Ext/T\0\0f\0\0\0"u8.ToArray(),
            Message("/VMC/Ext/Bone/Pos", "s", "Hips"), Message("/VMC/Ext/Bone/Pos", "sfffffff", "Hips"), Message("/VMC/Ext/Bone/Pos", "fffffff", 0f, 0f, 0f, 0f, 0f, 0f, 1f),
            Place("Hips", float.NaN), Place("Hips", float.PositiveInfinity), Place("Hips", 1e7f),
            Message("/VMC/Ext/Bone/Pos", "sfffffff", "Hips", 0f, 0f, 0f, 0f, 0f, 0f, 0f), Message("/VMC/Ext/Bone/Pos", "sfffffff", "Hips", 0f, 0f, 0f, 0f, float.NaN, 0f, 1f),
            Enumerable.Repeat(Message("/VMC/Ext/T", "f", 1f), 1).Aggregate((byte[])[], static (_, message) => Enumerable.Range(0, 9).Aggregate(message, static (inner, _) => Bundle(inner))),
        ];
        foreach (byte[] datagram in bad)
        {
            long before = _decoder.Rejected;
            _decoder.Receive(datagram);
            Assert.True(_decoder.Rejected == before + 1, Convert.ToHexString(datagram));
        }

        Receive(Message("/VMC/Ext/T", "f", 1f));
        Assert.Empty(Frames());
    }

    [Fact]
    public void Nothing_is_allocated()
    {
        List<byte[]> datagrams = Poses.Encode(new VmcEncoder(1, false, 0), Poses.Taken(Poses.Frame()));
        byte[] packet = new byte[2000];
        Allocations.AssertNone(() =>
        {
            foreach (byte[] datagram in datagrams)
                _decoder.Receive(datagram);

            Assert.True(_decoder.Read(packet) > 0);
        });
    }

    private static byte[] Place(string name, float x = 0, float y = 0, float z = 0) => Message("/VMC/Ext/Bone/Pos", "sfffffff", name, x, y, z, 0f, 0f, 0f, 1f);

    private static byte[] Bundle(params byte[][] messages)
    {
        byte[] bundle = [.. "#bundle\0"u8, 0, 0, 0, 0, 0, 0, 0, 1];
        foreach (byte[] message in messages)
            bundle = [.. bundle, .. Word(message.Length), .. message];

        return bundle;
    }

    private static byte[] Message(string address, string types, params object[] arguments) =>
    [
        .. Text(address), .. Text("," + types),
        .. arguments.SelectMany(static argument => argument is string text ? Text(text) : Word(argument is float number ? BitConverter.SingleToInt32Bits(number) : (int)argument)),
    ];

    private static byte[] Text(string text) => [.. System.Text.Encoding.ASCII.GetBytes(text), .. new byte[4 - (text.Length % 4)]];

    private static byte[] Word(int word) => [(byte)(word >> 24), (byte)(word >> 16), (byte)(word >> 8), (byte)word];

    private void Receive(params byte[][] messages) => _decoder.Receive(Bundle(messages));

    private List<MotionFrame> Frames()
    {
        List<MotionFrame> frames = [];
        byte[] packet = new byte[1480];
        while (_decoder.Length > 0)
        {
            Assert.Equal(packet.Length, _decoder.Read(packet));
            Assert.True(MotionHeader.TryRead(packet, out MotionHeader header));
            frames.Add(new MotionFrame(header, System.Runtime.InteropServices.MemoryMarshal.Cast<byte, float>(packet.AsSpan(64))));
        }

        return frames;
    }
}
