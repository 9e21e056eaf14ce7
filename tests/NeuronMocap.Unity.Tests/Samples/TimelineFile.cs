using System.Globalization;
using NeuronMocap.Unity.Timeline;
using UnityEngine.Timeline;

namespace NeuronMocap.Unity.Tests.Samples;

/// <summary>A Timeline in Unity's text format, as far as the samples use it.</summary>
internal sealed class TimelineFile
{
    private TimelineFile(TimelineAsset asset, IReadOnlyDictionary<long, TrackAsset> tracks) => (Asset, Tracks) = (asset, tracks);

    public TimelineAsset Asset { get; }

    /// <summary>The tracks by their numbers in the file.</summary>
    public IReadOnlyDictionary<long, TrackAsset> Tracks { get; }

    public static TimelineFile Load(string path)
    {
        SceneFile file = SceneFile.Read(path);
        Dictionary<long, SceneFile.Document> documents = file.Documents.ToDictionary(static document => document.Id);
        TimelineAsset asset = ScriptableObject.CreateInstance<TimelineAsset>();
        var tracks = new Dictionary<long, TrackAsset>();
        foreach (long id in documents[11400000].Items.Select(SceneFile.Reference))
        {
            Assert.Equal(typeof(MotionTrack), SceneFile.FindScript(SceneFile.Guid(documents[id])));
            MotionTrack track = asset.CreateTrack<MotionTrack>(null, documents[id]["m_Name"]);
            tracks.Add(id, track);
            foreach (IReadOnlyDictionary<string, string> values in documents[id].Parts("m_Clips"))
                AddClip(track, values, documents[SceneFile.Reference(values["m_Asset"])]);
        }

        return new TimelineFile(asset, tracks);
    }

    private static void AddClip(MotionTrack track, IReadOnlyDictionary<string, string> values, SceneFile.Document content)
    {
        Assert.Equal(typeof(MotionClip), SceneFile.FindScript(SceneFile.Guid(content)));
        TimelineClip clip = track.CreateClip<MotionClip>();
        SceneFile.SetFields(content, clip.asset, []);
        (clip.start, clip.duration) = (Number(values["m_Start"]), Number(values["m_Duration"]));
        (clip.clipIn, clip.timeScale) = (Number(values["m_ClipIn"]), Number(values["m_TimeScale"]));
        clip.displayName = values["m_DisplayName"];
    }

    private static double Number(string value) => double.Parse(value, CultureInfo.InvariantCulture);
}
