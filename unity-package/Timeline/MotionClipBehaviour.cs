#nullable enable

using UnityEngine.Playables;

namespace NeuronMocap.Unity.Timeline
{
    // A clip in a playing Timeline. Null if its file cannot be used.
    internal sealed class MotionClipBehaviour : PlayableBehaviour
    {
        public MotionTake? Take { get; set; }
    }
}
