using UnityEngine;

namespace Unity.LiveCapture;

public interface ITrackMetadata;

public interface ITakeBuilder
{
    double ContextStartTime { get; }

    void CreateAnimationTrack(string name, Animator animator, AnimationClip animationClip, ITrackMetadata? metadata = null, double? alignTime = null);
}
