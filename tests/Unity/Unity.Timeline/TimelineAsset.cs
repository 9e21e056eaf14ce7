using UnityEngine.Playables;

namespace UnityEngine.Timeline;

public class TimelineAsset : PlayableAsset
{
    private readonly List<TrackAsset> _tracks = [];

    public override double duration => _tracks.SelectMany(static track => track.GetClips()).Select(static clip => clip.end).DefaultIfEmpty().Max();

    public T CreateTrack<T>(TrackAsset? parent, string trackName)
        where T : TrackAsset, new()
    {
        T track = CreateInstance<T>();
        track.name = trackName;
        _tracks.Add(track);
        return track;
    }

    public override Playable CreatePlayable(PlayableGraph graph, GameObject owner)
    {
        var root = ScriptPlayable<TimelinePlayable>.Create(graph, _tracks.Count);
        PlayableDirector director = owner.GetComponent<PlayableDirector>();
        for (int i = 0; i < _tracks.Count; i++)
        {
            TrackAsset track = _tracks[i];
            Playable mixer = track.CreatePlayable(graph, owner);
            mixer.GetHandle().Checked.PlayerData = () => director.GetGenericBinding(track);
            root.ConnectInput(i, mixer, 0);
            root.SetInputWeight(i, 1);
            root.GetBehaviour().Mixers.Add((track, mixer));
        }

        return root;
    }
}

/// <summary>Gives clips their weights and local times.</summary>
public class TimelinePlayable : PlayableBehaviour
{
    internal List<(TrackAsset Track, Playable Mixer)> Mixers { get; } = [];

    public override void PrepareFrame(Playable playable, FrameData info)
    {
        double time = playable.GetTime();
        foreach ((TrackAsset track, Playable mixer) in Mixers)
        {
            TimelineClip[] clips = [.. track.GetClips()];
            for (int i = 0; i < clips.Length; i++)
            {
                float weight = clips[i].GetWeight(time, BlendIn(clips, clips[i]), BlendOut(clips, clips[i]));
                mixer.SetInputWeight(i, weight);
                if (weight > 0)
                    mixer.GetInput(i).SetTime(clips[i].ToLocalTime(time));
            }
        }
    }

    private static double BlendIn(TimelineClip[] clips, TimelineClip clip) =>
        clips.Where(other => other != clip && other.start < clip.start && other.end > clip.start).Select(other => other.end - clip.start).DefaultIfEmpty(clip.easeInDuration).Max();

    private static double BlendOut(TimelineClip[] clips, TimelineClip clip) =>
        clips.Where(other => other != clip && other.start > clip.start && other.start < clip.end).Select(other => clip.end - other.start).DefaultIfEmpty(clip.easeOutDuration).Max();
}
