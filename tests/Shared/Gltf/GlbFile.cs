using System.Numerics;
using System.Runtime.InteropServices;
using System.Text.Json;

namespace NeuronMocap.Tests.Gltf;

/// <summary>Reads a GLB file as a viewer does, and computes joints at any time. A second opinion on what the library writes.</summary>
internal sealed class GlbFile
{
    private readonly byte[] _binary;
    private readonly int[] _parents;

    private GlbFile(JsonElement json, byte[] binary)
    {
        Json = json;
        _binary = binary;
        _parents = [.. Nodes.Select(static _ => -1)];
        for (int node = 0; node < _parents.Length; node++)
        {
            foreach (JsonElement child in Items(Nodes[node], "children"))
                _parents[child.GetInt32()] = node;
        }
    }

    public JsonElement Json { get; }

    public IReadOnlyList<JsonElement> Nodes => Items(Json, "nodes");

    public IReadOnlyList<JsonElement> Animations => Items(Json, "animations");

    /// <summary>The names of figures or animations.</summary>
    public IReadOnlyList<string> Names(string property) => [.. Items(Json, property).Select(static item => item.GetProperty("name").GetString()!)];

    public static GlbFile Parse(byte[] bytes)
    {
        uint[] header = MemoryMarshal.Cast<byte, uint>(bytes.AsSpan(0, 20)).ToArray();
        Assert.Equal(0x46546C67u, header[0]);
        Assert.Equal(2u, header[1]);
        Assert.Equal((uint)bytes.Length, header[2]);
        Assert.Equal(0x4E4F534Au, header[4]);
        int end = 20 + (int)header[3];
        using var json = JsonDocument.Parse(bytes.AsMemory(20, (int)header[3]));
        byte[] binary = end < bytes.Length ? bytes[(end + 8)..] : [];
        return new GlbFile(json.RootElement.Clone(), binary);
    }

    /// <summary>The times of the keys of a bone, in seconds; empty if it has none.</summary>
    public float[] KeyTimes(int animation, string bone, string path = "rotation", int skin = 0) =>
        FindSampler(animation, Joint(skin, bone), path) is { } sampler ? Floats(sampler.GetProperty("input").GetInt32()) : [];

    /// <summary>The positions of the 59 joints in the world, in metres.</summary>
    public Vector3[] Joints(double time, int skin = 0, int? animation = 0)
    {
        var world = new Matrix4x4[Nodes.Count];
        for (int node = 0; node < world.Length; node++)
        {
            Vector3 position = Value(animation, node, "translation", 3, time) is { } place ? new(place.X, place.Y, place.Z) : RestPosition(node);
            Quaternion rotation = Value(animation, node, "rotation", 4, time) is { } turn ? new(turn.X, turn.Y, turn.Z, turn.W) : Quaternion.Identity;
            Matrix4x4 local = Matrix4x4.CreateFromQuaternion(rotation) * Matrix4x4.CreateTranslation(position);
            world[node] = _parents[node] < 0 ? local : local * world[_parents[node]];
        }

        return [.. Items(Items(Json, "skins")[skin], "joints").Select(joint => world[joint.GetInt32()].Translation)];
    }

    private int Joint(int skin, string bone) =>
        Items(Items(Json, "skins")[skin], "joints").Select(static joint => joint.GetInt32()).First(joint => Nodes[joint].GetProperty("name").GetString() == bone);

    private Vector3 RestPosition(int node)
    {
        JsonElement[] values = [.. Items(Nodes[node], "translation")];
        return values.Length == 0 ? Vector3.Zero : new Vector3(values[0].GetSingle(), values[1].GetSingle(), values[2].GetSingle());
    }

    private Vector4? Value(int? animation, int node, string path, int width, double time)
    {
        if (animation is not { } known || FindSampler(known, node, path) is not { } sampler)
            return null;

        float[] times = Floats(sampler.GetProperty("input").GetInt32());
        float[] values = Floats(sampler.GetProperty("output").GetInt32());
        Assert.Equal(times.Length * width, values.Length);
        int after = Array.FindIndex(times, key => key >= time);
        if (after <= 0)
            return Key(after < 0 ? times.Length - 1 : 0);

        float part = (float)((time - times[after - 1]) / (times[after] - times[after - 1]));
        (Vector4 from, Vector4 to) = (Key(after - 1), Key(after));
        if (width == 3)
            return Vector4.Lerp(from, to, part);

        var turn = Quaternion.Slerp(new Quaternion(from.X, from.Y, from.Z, from.W), new Quaternion(to.X, to.Y, to.Z, to.W), part);
        return new Vector4(turn.X, turn.Y, turn.Z, turn.W);

        Vector4 Key(int index) => new(values[index * width], values[(index * width) + 1], values[(index * width) + 2], width == 4 ? values[(index * width) + 3] : 0);
    }

    private JsonElement? FindSampler(int animation, int node, string path)
    {
        foreach (JsonElement channel in Items(Animations[animation], "channels"))
        {
            JsonElement target = channel.GetProperty("target");
            if (target.GetProperty("node").GetInt32() == node && target.GetProperty("path").GetString() == path)
                return Items(Animations[animation], "samplers")[channel.GetProperty("sampler").GetInt32()];
        }

        return null;
    }

    private float[] Floats(int number)
    {
        JsonElement accessor = Items(Json, "accessors")[number];
        JsonElement view = Items(Json, "bufferViews")[accessor.GetProperty("bufferView").GetInt32()];
        Assert.Equal(5126, accessor.GetProperty("componentType").GetInt32());
        return MemoryMarshal.Cast<byte, float>(_binary.AsSpan((int)view.GetProperty("byteOffset").GetInt64(), (int)view.GetProperty("byteLength").GetInt64())).ToArray();
    }

    private static IReadOnlyList<JsonElement> Items(JsonElement element, string property) =>
        element.TryGetProperty(property, out JsonElement items) ? [.. items.EnumerateArray()] : [];
}
