#nullable enable

using System;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // The place of the performers in the scene.
    public sealed partial class MocapSource
    {
        [NonSerialized]
        private StageCenter? _center;

        /// <summary>
        /// Gets where the mocap stage of this source is. With it, performers of several sources meet in one scene. Changes apply in the next frame.
        /// </summary>
        public SourceStage Stage => _stage;

        /// <summary>Gets or sets the key that calls <see cref="Recenter()"/>. The default is none.</summary>
        /// <remarks>It works with the old Input Manager and with the package Input System, which reads keys of the keyboard only.</remarks>
        public KeyCode RecenterKey
        {
            get => _recenterKey;
            set => _recenterKey = value;
        }

        /// <summary>
        /// Recentres on the first live performer: the place and the facing of its hips become origin and forward of the stage. All performers of the
        /// source move along. If no performer is live, it does nothing.
        /// </summary>
        public void Recenter()
        {
            for (int i = 0; i < _performers.Count; i++)
            {
                if (_performers[i].IsLive && Recenter(_performers[i]))
                    return;
            }
        }

        /// <summary>Recentres on a performer, like <see cref="Recenter()"/>. It applies with the next frame, also after the source reopens.</summary>
        /// <param name="performer">A performer of this source.</param>
        /// <returns>False if the performer has no pose yet, or belongs to another source.</returns>
        public bool Recenter(Performer performer)
        {
            if (performer is null)
                throw new ArgumentNullException(nameof(performer));
            if (!performer.HasPose || !_performers.Contains(performer))
                return false;

            _center = new StageCenter(performer.StreamedHips);
            return true;
        }

        /// <summary>Undoes <see cref="Recenter()"/>: the origin of the stage is the server's again.</summary>
        public void ClearCenter() => _center = null;

        private StagePlacement GetPlacement() => new StagePlacement(_stage, _center ?? StageCenter.None);

        private void FollowRecenterKey()
        {
            if (KeyPresses.IsPressed(_recenterKey))
                Recenter();
        }
    }
}
