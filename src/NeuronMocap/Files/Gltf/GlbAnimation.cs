using NeuronMocap.Skeleton;

namespace NeuronMocap.Gltf;

// The description of an avatar's animation. Tracks with a key for each frame share their times.
internal sealed class GlbAnimation
{
    private readonly GlbAvatar _avatar;
    private readonly GlbFigure _figure;
    private readonly GlbBinary _binary;
    private readonly List<(int Times, int Values, int Bone, string Path)> _channels = [];
    private int? _allTimes;
    private int? _firstTime;

    public GlbAnimation(GlbAvatar avatar, GlbFigure figure, GlbBinary binary)
    {
        (_avatar, _figure, _binary) = (avatar, figure, binary);
        PoseAnimation animation = avatar.Animation;
        for (int bone = 0; bone < BoneHierarchy.BoneCount; bone++)
        {
            if (animation.GetPosition(bone, avatar.Body.Offsets[bone]) is { } positions)
                Add(positions, bone, "translation", "VEC3");

            Add(animation.GetRotation(bone), bone, "rotation", "VEC4");
        }
    }

    public void Describe(GltfJson json)
    {
        json.Object().Text("name", _avatar.Name).Array("samplers");
        foreach ((int times, int values, _, _) in _channels)
            json.Object().Number("input", times).Number("output", values).EndObject();

        json.EndArray().Array("channels");
        for (int i = 0; i < _channels.Count; i++)
        {
            json.Object().Number("sampler", i);
            json.Object("target").Number("node", _figure.GetNode(_channels[i].Bone)).Text("path", _channels[i].Path).EndObject().EndObject();
        }

        json.EndArray().EndObject();
    }

    private void Add(KeyTrack track, int bone, string path, string type)
    {
        int values = _binary.Add(new GlbAccessor(GlbAccessor.Float, track.KeyCount, type), null, track.CopyValuesTo);
        _channels.Add((GetTimes(track), values, bone, path));
    }

    private int GetTimes(KeyTrack track)
    {
        PoseAnimation animation = _avatar.Animation;
        if (track.IsConstant)
            return _firstTime ??= AddTimes(1, animation.FirstTime, animation.FirstTime, WriteFirstTime);
        if (track.Times is { } own)
            return AddTimes(own.Count, animation.FirstTime, animation.LastTime, own.CopyTo);

        return _allTimes ??= AddTimes(animation.Times.Count, animation.FirstTime, animation.LastTime, animation.Times.CopyTo);
    }

    private int AddTimes(long count, float first, float last, Action<Stream> write) =>
        _binary.Add(new GlbAccessor(GlbAccessor.Float, count, "SCALAR") { Min = [first], Max = [last] }, null, write);

    private void WriteFirstTime(Stream output) => output.Write(BitConverter.GetBytes(_avatar.Animation.FirstTime), 0, sizeof(float));
}
