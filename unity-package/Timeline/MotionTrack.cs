#nullable enable

using System.ComponentModel;
using UnityEngine;
using UnityEngine.Playables;
using UnityEngine.Timeline;

namespace NeuronMocap.Unity.Timeline
{
    /// <summary>
    /// A Timeline track that moves a figure with BVH files and recordings. Bind it to the figure's driver. While a clip plays, the figure does not follow
    /// its performer.
    /// </summary>
    [DisplayName("NeuronMocap/Motion Track")]
    [TrackColor(0.95f, 0.42f, 0.1f)]
    [TrackClipType(typeof(MotionClip))]
    [TrackBindingType(typeof(FigureDriver))]
    public sealed class MotionTrack : TrackAsset
    {
        /// <summary>Creates the playable that blends the clips.</summary>
        /// <param name="graph">The graph.</param>
        /// <param name="go">The object of the director.</param>
        /// <param name="inputCount">The number of clips.</param>
        /// <returns>The playable.</returns>
        public override Playable CreateTrackMixer(PlayableGraph graph, GameObject go, int inputCount) =>
            ScriptPlayable<MotionMixer>.Create(graph, inputCount);

        /// <summary>Names the properties that a preview in edit mode changes, so that Timeline restores them.</summary>
        /// <param name="director">The director of the track.</param>
        /// <param name="driver">Receives the properties.</param>
        public override void GatherProperties(PlayableDirector director, IPropertyCollector driver)
        {
            if (!(director.GetGenericBinding(this) is FigureDriver figure) || figure == null || !(figure.FindRig(out _) is { } rig))
                return;

            foreach (Transform node in rig.Nodes)
            {
                if (node == null)
                    continue;

                driver.AddFromName<Transform>(node.gameObject, "m_LocalPosition");
                driver.AddFromName<Transform>(node.gameObject, "m_LocalRotation");
            }
        }
    }
}
