#nullable enable

using NeuronMocap.Skeleton;
using UnityEngine.Playables;

namespace NeuronMocap.Unity.Timeline
{
    // Moves a figure to the mean of the track's clips, by their weights. It is called in edit mode as well.
    internal sealed class MotionMixer : PlayableBehaviour
    {
        private readonly BoneTransform[] _pose = new BoneTransform[BoneHierarchy.BoneCount];
        private FigureDriver? _driver;

        public override void ProcessFrame(Playable playable, FrameData info, object? playerData)
        {
            var driver = playerData as FigureDriver;
            if (driver == null || !ReferenceEquals(driver, _driver))
                Release();
            if (driver == null)
                return;

            _driver = driver;
            bool isPosed = false;
            for (int i = 0; i < playable.GetInputCount(); i++)
            {
                float weight = playable.GetInputWeight(i);
                if (!(weight > 0))
                    continue;

                var clip = (ScriptPlayable<MotionClipBehaviour>)playable.GetInput(i);
                if (!(clip.GetBehaviour().Take is { } take))
                    continue;

                take.Sample(clip.GetTime(), _pose);
                isPosed |= driver.AddPose(_pose, take.Body, weight);
            }

            if (isPosed)
                driver.EndPose(this);
            else
                driver.ReleasePose(this);
        }

        public override void OnPlayableDestroy(Playable playable) => Release();

        // A driver that was removed leaves its figure behind, which has to return to its pose in the scene as well.
        private void Release()
        {
            if (!(_driver is null))
                _driver.ReleasePose(this);

            _driver = null;
        }
    }
}
