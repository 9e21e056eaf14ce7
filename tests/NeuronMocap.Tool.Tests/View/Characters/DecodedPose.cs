using System.Buffers.Binary;
using System.Numerics;
using NeuronMocap.Frames;
using NeuronMocap.Tool.View.Characters;

namespace NeuronMocap.Tool.Tests.View.Characters;

/// <summary>What the page does with a pose of a character: it sets the nodes of the file, and the scene computes their world transforms.</summary>
internal sealed class DecodedPose
{
    private const int HeaderSize = 28;

    private readonly CharacterNode[] _nodes;

    public DecodedPose(IReadOnlyList<CharacterNode> nodes, CharacterRig rig, ReadOnlySpan<byte> pose)
    {
        Assert.Equal((1, 2), (pose[0], pose[1]));
        Assert.Equal(rig.Bones.Length, BinaryPrimitives.ReadUInt16LittleEndian(pose[2..]));
        Assert.Equal(HeaderSize + (rig.Bones.Length * CompactRotation.Size), pose.Length);
        Character = BinaryPrimitives.ReadUInt32LittleEndian(pose[4..]);
        Microseconds = BinaryPrimitives.ReadInt64LittleEndian(pose[8..]);
        _nodes = [.. nodes];
        var hips = new Vector3(Single(pose[16..]), Single(pose[20..]), Single(pose[24..]));
        _nodes[rig.HipsNode] = _nodes[rig.HipsNode] with { Translation = hips };
        for (int i = 0; i < rig.Bones.Length; i++)
        {
            Assert.True(CompactRotation.TryRead(pose.Slice(HeaderSize + (i * CompactRotation.Size), CompactRotation.Size), out Quaternion rotation));
            int node = rig.Bones[i].Node;
            _nodes[node] = _nodes[node] with { Rotation = rotation };
        }
    }

    public uint Character { get; }

    public long Microseconds { get; }

    /// <summary>Computes the world matrices of nodes, with glTF's rules.</summary>
    public static Matrix4x4[] WorldOf(IReadOnlyList<CharacterNode> nodes)
    {
        var world = new Matrix4x4[nodes.Count];
        for (int i = 0; i < world.Length; i++)
        {
            CharacterNode node = nodes[i];
            Matrix4x4 local = Matrix4x4.CreateScale(node.Scale)
                * Matrix4x4.CreateFromQuaternion(Quaternion.Normalize(node.Rotation))
                * Matrix4x4.CreateTranslation(node.Translation);
            world[i] = node.Parent < 0 ? local : local * world[node.Parent];
        }

        return world;
    }

    public Matrix4x4[] World() => WorldOf(_nodes);

    private static float Single(ReadOnlySpan<byte> source) => BinaryPrimitives.ReadSingleLittleEndian(source);
}
