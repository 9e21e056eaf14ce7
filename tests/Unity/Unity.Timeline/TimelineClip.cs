using UnityEngine.Playables;

namespace UnityEngine.Timeline;

[Flags]
public enum ClipCaps
{
    None = 0,
    Looping = 1,
    Extrapolation = 2,
    ClipIn = 4,
    SpeedMultiplier = 8,
    Blending = 16,
}

public interface ITimelineClipAsset
{
    ClipCaps clipCaps { get; }
}

/// <summary>A part of a track. Where two clips overlap, one blends into the other.</summary>
public class TimelineClip
{
    internal TimelineClip(Object asset)
    {
        this.asset = asset;
        duration = ((PlayableAsset)asset).duration;
    }

    public Object asset { get; set; }

    public string displayName { get; set; } = "";

    public double start { get; set; }

    public double duration { get; set; }

    public double end => start + duration;

    public double clipIn { get; set; }

    public double timeScale { get; set; } = 1;

    public double easeInDuration { get; set; }

    public double easeOutDuration { get; set; }

    public double ToLocalTime(double time) => ((time - start) * timeScale) + clipIn;

    /// <summary>The weight at a time, with straight lines where Unity has curves.</summary>
    internal float GetWeight(double time, double blendIn, double blendOut)
    {
        if (time < start || time >= end)
            return 0;

        double into = blendIn > 0 ? Math.Min((time - start) / blendIn, 1) : 1;
        double outOf = blendOut > 0 ? Math.Min((end - time) / blendOut, 1) : 1;
        return (float)(into * outOf);
    }
}
