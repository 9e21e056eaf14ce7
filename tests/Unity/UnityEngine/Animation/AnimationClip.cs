namespace UnityEngine;

public class Motion : Object
{
}

public sealed class AnimationClip : Motion
{
    public float frameRate { get; set; } = 60;

    public bool legacy { get; set; }

    public WrapMode wrapMode { get; set; }

    public float length => Curves.Values.SelectMany(static curve => curve.keys).Select(static key => key.time).DefaultIfEmpty(1).Max();

    public bool empty => Curves.Count == 0;

    public bool isHumanMotion => Curves.Keys.Any(static key => key.Type == typeof(Animator));

    internal Dictionary<(string Path, Type Type, string Property), AnimationCurve> Curves { get; } = [];

    /// <summary>At run time, Unity accepts curves only for legacy clips.</summary>
    public void SetCurve(string relativePath, Type type, string propertyName, AnimationCurve? curve)
    {
        if (!legacy && StandIn.World.IsPlaying)
            Debug.LogError("Can't use AnimationClip::SetCurve at Runtime on a non-legacy AnimationClip.");
        else
            Set(relativePath, type, propertyName, curve);
    }

    public void ClearCurves() => Curves.Clear();

    public void EnsureQuaternionContinuity()
    {
    }

    internal void Set(string path, Type type, string property, AnimationCurve? curve)
    {
        if (curve is null)
            Curves.Remove((path, type, property));
        else
            Curves[(path, type, property)] = curve;
    }
}

public enum WrapMode
{
    Default = 0,
    Once = 1,
    Loop = 2,
    PingPong = 4,
    ClampForever = 8,
}
