#nullable enable

using UnityEngine;

namespace NeuronMocap.Unity
{
    // Durations of frames for what follows real time. While a film is captured, frames take longer than they last in the film, and each time
    // differently.
    internal static class FrameTime
    {
        public static float Delta => Time.captureDeltaTime > 0 ? Time.deltaTime : Time.unscaledDeltaTime;
    }
}
