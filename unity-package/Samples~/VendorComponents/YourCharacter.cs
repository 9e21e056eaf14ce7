#nullable enable
using NeuronMocap.Skeleton;
using UnityEngine;

namespace NeuronMocap.Unity.Samples
{
    /// <summary>Takes the place of your own character in this scene: builds a Humanoid figure with the bone names of the stream.</summary>
    public sealed class YourCharacter : MonoBehaviour
    {
        private HumanoidFigure? _figure;

        private void Start() => _figure = HumanoidFigure.Build(SkeletonBody.GetDefault(), parent: transform);

        private void OnDestroy() => _figure?.Dispose();
    }
}
