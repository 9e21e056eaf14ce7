using UnityEngine;

namespace Unity.LiveCapture;

/// <summary>Records all devices that are ready, and asks those for their tracks at the end.</summary>
public static class TakeRecorder
{
    private static readonly List<LiveCaptureDevice> Recording = [];

    public static FrameRate FrameRate { get; set; } = new(30);

    public static bool IsLive { get; set; } = true;

    internal static List<LiveCaptureDevice> Devices { get; } = [];

    /// <summary>For tests: the tracks of the last take.</summary>
    internal static IReadOnlyList<(string Name, Animator Animator, AnimationClip Clip)> Tracks { get; private set; } = [];

    public static bool IsRecording() => Recording.Count > 0;

    public static void StartRecording()
    {
        // A new project discards the devices of the last one.
        Devices.RemoveAll(static device => device == null);
        foreach (LiveCaptureDevice device in Devices)
        {
            device.StartRecording();
            if (device.IsRecording)
                Recording.Add(device);
        }
    }

    public static void StopRecording()
    {
        var builder = new TakeBuilder();
        foreach (LiveCaptureDevice device in Recording)
        {
            device.StopRecording();
            device.Write(builder);
        }

        Recording.Clear();
        Tracks = builder.Tracks;
    }

    private sealed class TakeBuilder : ITakeBuilder
    {
        public List<(string Name, Animator Animator, AnimationClip Clip)> Tracks { get; } = [];

        public double ContextStartTime => 0;

        public void CreateAnimationTrack(string name, Animator animator, AnimationClip animationClip, ITrackMetadata? metadata = null, double? alignTime = null) =>
            Tracks.Add((name, animator, animationClip));
    }
}
