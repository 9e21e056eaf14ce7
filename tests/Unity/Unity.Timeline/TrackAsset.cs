#pragma warning disable CA1019 // As Unity's are.
using UnityEngine.Playables;

namespace UnityEngine.Timeline;

[AttributeUsage(AttributeTargets.Class)]
public sealed class TrackColorAttribute(float r, float g, float b) : Attribute
{
    public Color color { get; } = new(r, g, b);
}

[AttributeUsage(AttributeTargets.Class, AllowMultiple = true)]
public sealed class TrackClipTypeAttribute(Type clipClass) : Attribute
{
    public Type inspectedType { get; } = clipClass;
}

[AttributeUsage(AttributeTargets.Class)]
public sealed class TrackBindingTypeAttribute(Type type) : Attribute
{
    public Type type { get; } = type;
}

/// <summary>Takes over the properties that a preview changes, to restore them after it.</summary>
public interface IPropertyCollector
{
    void AddFromName<T>(GameObject obj, string name)
        where T : Component;
}

public abstract class TrackAsset : PlayableAsset
{
    private readonly List<TimelineClip> _clips = [];

    public IEnumerable<TimelineClip> GetClips() => _clips;

    /// <summary>Creates a clip at the end of the track, as long as its asset.</summary>
    public TimelineClip CreateClip<T>()
        where T : ScriptableObject, IPlayableAsset
    {
        Type[] allowed = [.. GetType().GetCustomAttributes(typeof(TrackClipTypeAttribute), true).Cast<TrackClipTypeAttribute>().Select(static item => item.inspectedType)];
        if (!allowed.Any(static type => type.IsAssignableFrom(typeof(T))))
            throw new InvalidOperationException($"Clips of type {typeof(T)} are not supported on tracks of type {GetType()}.");

        var clip = new TimelineClip(CreateInstance<T>()) { start = _clips.Select(static item => item.end).DefaultIfEmpty().Max() };
        _clips.Add(clip);
        return clip;
    }

    public virtual Playable CreateTrackMixer(PlayableGraph graph, GameObject go, int inputCount) => Playable.Null;

    public virtual void GatherProperties(PlayableDirector director, IPropertyCollector driver)
    {
    }

    public override Playable CreatePlayable(PlayableGraph graph, GameObject owner)
    {
        Playable mixer = CreateTrackMixer(graph, owner, _clips.Count);
        for (int i = 0; i < _clips.Count; i++)
            mixer.ConnectInput(i, ((PlayableAsset)_clips[i].asset).CreatePlayable(graph, owner), 0);

        return mixer;
    }
}
