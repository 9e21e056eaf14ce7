#nullable enable
using UnityEngine;

namespace NeuronMocap.Unity.Samples
{
    /// <summary>Says what to install if the project lacks the package Timeline. Without it, the figure stands still.</summary>
    public sealed class TimelineNote : MonoBehaviour
    {
        /// <summary>The text that is shown in the console and in the game view.</summary>
        public const string Text =
            "This scene needs the package Timeline. Open the Package Manager, choose Unity Registry, install Timeline, and open the scene again.";

        /// <summary>Gets whether the project has the package Timeline.</summary>
#if NEURONMOCAP_TIMELINE
        public static bool HasTimeline => true;
#else
        public static bool HasTimeline => false;
#endif

        private void Start()
        {
            if (!HasTimeline)
                Debug.LogWarning(Text, this);
        }

        private void OnGUI()
        {
            if (!HasTimeline)
                GUI.Label(new Rect(10, 10, 600, 40), Text);
        }
    }
}
